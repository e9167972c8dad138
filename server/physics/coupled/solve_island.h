#pragma once
// Projected Newton on an island's potential.

#include "server/physics/coupled/island.h"

namespace prosector {

/// Minimises the island's energy over one tick of h seconds, then finishes the soft bodies' stages and fills
/// the rigid twists and the contacts' forces. Each Newton step solves with the first soft body's linear
/// solver and settings (an island without one: conjugate gradients) and descends by Armijo's rule, so a solve
/// that stops early is still a descent; what was left is in the report. Rigid bodies take the whole tick in
/// every stage of a multi-stage integrator; the last stage's result counts. Where several bodies move
/// together, rigid or soft, all are stepped by implicit Euler: other methods weigh a force otherwise than a
/// rigid body does, and momentum would be lost between them. A tick that is not finite, or after which a soft
/// body has more energy than explained, is taken again with more care, by implicit Euler, and if need be
/// shortened: energy_guard.h.
IslandReport solve_island(Island& island, double h, const Vec3& gravity);

}  // namespace prosector
