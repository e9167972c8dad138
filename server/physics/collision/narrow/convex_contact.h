#pragma once
// Convex shapes against each other: distance by GJK, depth by EPA.

#include <optional>

#include "server/physics/collision/primitives/proximity.h"
#include "server/physics/collision/shapes/convex.h"

namespace prosector {

/// Computes distance by our GJK (gjk.h) and depth by the expanding polytope (van den Bergen 2001). The latter
/// is Bullet's, in single precision, where that proves itself. Its polytope says how deep at least; the two
/// supporting planes with its normal, in double precision, say how deep at most. Where the two differ, the
/// normal is searched for from many directions. The depth told is that of the planes: never less than the
/// true one, so what touches is never missed.
///
/// Bullet alone does not do. It was tried on 1,856 pairs of random polytopes a metre or so across that were
/// apart. At the scale that suited it best, its GJK was off by more than 10 µm in 1 % of them. The worst was
/// off by 56 mm (btGjkPairDetector: by 0.6 mm). Its EPA was right to 0.14 µm in all of 1,144 pairs that
/// overlapped. But of 300 pairs of balls given as ellipsoids it took some for twice as deep, from the wrong
/// side.
///
/// The poses are those of a and b in any one frame, which is also that of the result. Returns nothing when
/// farther apart than `margin`.
std::optional<Proximity> convex_proximity(const Convex& a, const Pose& pose_a, const Convex& b,
                                          const Pose& pose_b, double margin);

}  // namespace prosector
