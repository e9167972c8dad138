#pragma once
// Bodies of a rigid world in code.

#include <utility>
#include <vector>

#include "server/physics/mechanics/rigid/rigid_world.h"

namespace prosector::test {

/// A collision part with its half extents or radii `half` (m, as in ShapePart), `at` m from the body's
/// centre.
inline collision::ShapePart rigid_part(collision::ShapeKind kind, const Vec3& half,
                                       const Vec3& at = Vec3::Zero()) {
  collision::ShapePart out;
  out.kind = kind;
  out.half = half;
  out.pose.p = at;
  return out;
}

/// A homogeneous body without friction. `mass`: kg; 0: fixed.
inline rigid::RigidSetup rigid_setup(std::vector<collision::ShapePart> parts, double mass) {
  rigid::RigidSetup out;
  out.parts = std::move(parts);
  out.mass = mass;
  if (mass > 0) {
    std::vector<collision::MassProperties> each;
    for (const collision::ShapePart& part : out.parts) each.push_back(collision::part_mass(part, 1));
    const collision::MassProperties whole = collision::combine(each);
    out.inertia = mass / whole.mass * whole.inertia.diagonal();
  }
  out.friction = 0;
  return out;
}

/// A motion at `at` (m) with `velocity` (m/s), unrotated.
inline rigid::RigidMotion rigid_motion(const Vec3& at, const Vec3& velocity) {
  rigid::RigidMotion out;
  out.pose.p = at;
  out.linear_velocity = velocity;
  return out;
}

}  // namespace prosector::test
