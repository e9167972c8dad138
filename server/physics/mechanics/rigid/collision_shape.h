#pragma once
// Collision shape of a rigid body.

#include <vector>

#include "common/fidelity.h"
#include "server/physics/mechanics/collision/shapes/shape.h"

namespace prosector::rigid {

/// Returns the collision parts that replace a rigid body's given parts at this fidelity. Contact response and
/// detection use the same parts. `pose`: the body's pose in the room when the scene starts.
///
/// `none` gives no parts, and `hull` and `mesh` return the parts unchanged. `sphere` gives a ball around the
/// centre of the parts' bounding box. `aabb` gives a box that is aligned with the room's axes at `pose`. It
/// rotates with the body: a box with fixed axes would take no moment, and refitting it would push neighbours.
/// `obb` gives the smaller of two boxes, along the body's axes and along the principal axes of its points.
/// The ball and the boxes enclose the parts.
std::vector<collision::ShapePart> at_fidelity(std::vector<collision::ShapePart> parts, Fidelity fidelity,
                                              const Pose& pose);

}  // namespace prosector::rigid
