#pragma once
// Projected Newton on an island's potential.

#include "server/physics/coupled/island.h"

namespace prosector {

/// Minimises the island's energy over one tick of h seconds, then finishes the soft bodies' stages and fills
/// the rigid twists and the contacts' forces. Each Newton step solves with the first soft body's linear
/// solver and settings (an island without one: conjugate gradients) and descends by Armijo's rule, so a solve
/// that stops early is still a descent; what was left is in the report. Rigid bodies take the whole tick in
/// every stage of a multi-stage integrator; the last stage's result counts.
IslandReport solve_island(Island& island, double h, const Vec3& gravity);

}  // namespace prosector
