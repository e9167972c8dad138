#pragma once
// Where the anatomy of a scene lies: what a first view is to show.

#include "client/replica/replica.h"

namespace prosector {

/// Returns points (m, world frame, at rest) of the soft bodies and of the parts near them; where there are
/// none, of what moves; none: nothing does.
std::vector<Vec3> anatomy_points(Replica& replica);

}  // namespace prosector
