#pragma once
// Nearest point of a capsule, such as a finger segment, to a rigid body.

#include "server/physics/mechanics/contact/surface_detector.h"
#include "server/physics/mechanics/rigid/rigid_world.h"

namespace prosector {

/// A capsule along the y axis of its frame, with its centre at the origin.
struct Capsule {
  double length = 0;  // m, of its axis
  double radius = 0;  // m
};

/// Returns the contact of a capsule, with its centre at `pose`, with the body, from our own shapes. `along`:
/// position on the capsule's axis, m from its centre. Sets the points, normal and gap only; the capsule is
/// side a; world frame. If the gap is larger than `margin` (m), it is only a lower bound.
rigid::RigidContact touch_of(const Capsule& capsule, const Pose& pose, const contact::Collider& body,
                             double along, double margin);

/// Returns the capsule's point nearest to the body, m along its axis, by alternating projections from `from`
/// (m along the axis). Gaps larger than `margin` (m) need not be exact.
double nearest_along(const Capsule& capsule, const Pose& pose, const contact::Collider& body, double from,
                     double margin);

/// Returns the same from `place` (m, world frame). If the capsule lies along the body, all points between two
/// places are nearly as near. Then it returns a point between them, closer to the one that is nearer to the
/// body.
double middle_along(const Capsule& capsule, const Pose& pose, const contact::Collider& body,
                    const Vec3& place, double margin);

}  // namespace prosector
