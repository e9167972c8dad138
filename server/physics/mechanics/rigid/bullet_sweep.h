#pragma once
// Continuous collision detection for bodies of several parts, which Bullet does not sweep. Only for the .cpp
// files of this folder.

#include "server/physics/mechanics/rigid/bullet_types.h"

namespace prosector::rigid {

/// Fraction of a part's least half extent: radius of the ball that is swept in it, as by Bullet.
inline constexpr double swept_share = 0.5;

/// Returns the fraction, in (0, 1], of the body's motion over `h` s that ends where one of its convex parts
/// meets another body. A part is swept as a ball in its middle, if it moves farther than its least half
/// extent, and if the body does not touch the other one already. 1: nothing is met, or the body is not a
/// compound.
btScalar free_motion(btCollisionWorld& world, const btRigidBody& body, btScalar h);

}  // namespace prosector::rigid
