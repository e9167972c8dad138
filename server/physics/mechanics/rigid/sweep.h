#pragma once
// Sweep of a fast rigid body along its path within a step, so that it stops at what it would pass through.
// Only for the .cpp files of this folder.

#include "server/physics/mechanics/rigid/bullet_types.h"

namespace prosector::rigid {

/// Returns a bound of the speed of a body's points, m/s.
double fastest_point(const btRigidBody& body);
/// Returns the fraction in (0, 1] of a body's motion over `h` s after which it first overlaps another object
/// of the world. Objects that it overlaps at the start don't count. Objects to which it moves by less than
/// `half_thickness` (m, half of its least extent) don't count either, since ordinary detection finds them in
/// time. `filter` decides which objects collide. Other objects are taken to move on at their current
/// velocity, without rotation.
double unobstructed_share(btCollisionWorld& world, btOverlapFilterCallback& filter, btRigidBody& body,
                          double half_thickness, double h);

}  // namespace prosector::rigid
