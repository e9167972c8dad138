#pragma once
// Collision shape of a rigid body.

#include <vector>

#include "server/physics/mechanics/collision/shapes/fidelity.h"
#include "server/physics/mechanics/collision/shapes/shape.h"

namespace prosector {

/// Returns the collision parts for the given parts at a fidelity. Contact response and detection use the same
/// parts.
///   none    no parts
///   sphere  a ball around the centre of their bounding box
///   aabb    a box along the room's axes at `pose`, the body's pose in the room when the scene starts; it
///           rotates with the body: a fixed-axes box would take no moment, and refitting would push
///           neighbours
///   obb     the smaller of the boxes along the body's axes and along the principal axes of its points
///   hull    the parts unchanged: convex pieces, round ones exactly
///   mesh    the parts unchanged, and triangles
///
/// sphere, aabb and obb enclose the parts.
std::vector<ShapePart> at_fidelity(std::vector<ShapePart> parts, Fidelity fidelity, const Pose& pose);

}  // namespace prosector
