#pragma once
// Contact of convex shapes: distance by GJK, depth by EPA.

#include <optional>

#include "server/physics/mechanics/collision/primitives/proximity.h"
#include "server/physics/mechanics/collision/shapes/convex.h"

namespace prosector::collision {

/// Returns the distance or the penetration depth of two convex shapes, with normal and closest points. The
/// distance is computed by our GJK (gjk.h). The depth is computed by Bullet's expanding polytope algorithm
/// (EPA, van den Bergen 2001), which is single precision. The polytope gives a lower bound of the depth. The
/// two supporting planes with the polytope's normal, in double precision, give an upper bound. If the bounds
/// differ, the normal is searched from many start directions. The returned depth is that of the planes: it is
/// never less than the true depth, so no contact is missed.
///
/// Bullet's own GJK is not accurate enough. It was tested on 1,856 separated pairs of random polytopes about
/// a metre across. At its best scale, the error exceeded 10 µm in 1 % of the pairs. The largest error was 56
/// mm (btGjkPairDetector: 0.6 mm). Bullet's EPA was correct to 0.14 µm in all of 1,144 overlapping pairs. For
/// some of 300 pairs of spheres given as ellipsoids, it returned twice the depth, with a normal on the wrong
/// side.
///
/// Both poses are in the same frame, and so is the result. Returns nothing if the shapes are farther apart
/// than `margin`, m.
std::optional<Proximity> convex_proximity(const Convex& a, const Pose& pose_a, const Convex& b,
                                          const Pose& pose_b, double margin);

}  // namespace prosector::collision
