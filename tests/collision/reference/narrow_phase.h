#pragma once
// How near, and when, two objects of the reference meet.

#include <optional>

#include "tests/collision/reference/collision_object.h"

namespace prosector {

/// The deepest, or nearest, of all pairs of pieces, each object at its own fidelity. Nothing when farther
/// apart than `margin` (m), or when one has no pieces.
std::optional<collision::Proximity> proximity(const CollisionObject& a, const CollisionObject& b,
                                              double margin);

struct Impact {
  double time = 0;          // s from now
  bool converged = true;    // false: they are not nearer than that before this time, and may never be
  collision::Proximity at;  // at that time
};

/// The first time within h seconds, velocities constant, at which their gap is at most `slop` (m, above 0):
/// by conservative advancement (Mirtich 1996), which goes ahead by what no point can cross: it never passes
/// an impact. 0 for what touches now. Shapes of triangles, and soft ones, take many steps where they slide
/// past each other nearly touching; after 200 it stops and says so.
std::optional<Impact> time_of_impact(const CollisionObject& a, const CollisionObject& b, double h,
                                     double slop);

}  // namespace prosector
