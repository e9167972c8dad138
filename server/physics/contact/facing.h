#pragma once
// Which side of a thing a surface vertex of tissue is on.
//
// The nearest way out of a thing is the wrong one in two cases. Tissue that is pressed in by more than half
// the thing's thickness would go on through. And where an edge has run over a vertex by a hair, its side
// would stop there, though what is under it gives way. A vertex that was pressed in goes back where it came
// in. One that is met for the first time goes back into its own tissue, against its surface's normal.

#include "server/physics/contact/surface_detector.h"

namespace prosector {

/// What is known of a vertex that came near a thing.
struct Approach {
  Vec3 at = Vec3::Zero();        // m, world frame
  Distance nearest;              // of the thing there
  const Vec3* before = nullptr;  // unit: the contact's normal in the last tick, if it pressed then …
  double depth = 0;              // … and how deep it was when that ended, m
  Vec3 outward = Vec3::Zero();   // out of the tissue, unit; zero: it has no inside
  double lip = 0;                // m: an edge runs over less than this
};

/// Returns the contact's gap and normal; none: it is left out, the thing's edge passes it along.
std::optional<Distance> side_of(const Collider& collider, const Approach& vertex);

}  // namespace prosector
