#pragma once
// What a rigid body collides as.

#include <vector>

#include "server/physics/collision/shapes/fidelity.h"
#include "server/physics/collision/shapes/shape.h"

namespace prosector {

/// Returns the parts that stand for the given ones at a fidelity: response and detection use these alike.
///   none    nothing
///   sphere  a ball about the middle of their box
///   aabb    a box along the room's axes at `pose`, the body's in the room when the scene starts; it turns
///           with the body: a box that didn't would take no moment, and push as it is fitted anew
///   obb     the smaller of the boxes along the body's axes and along the principal ones of its points
///   hull    the parts as they are: convex pieces, round ones exactly
///   mesh    the parts as they are, and triangles
///
/// sphere, aabb and obb enclose the parts.
std::vector<ShapePart> at_fidelity(std::vector<ShapePart> parts, Fidelity fidelity, const Pose& pose);

}  // namespace prosector
