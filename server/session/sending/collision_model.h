#pragma once
// Outlines of the shapes that bodies collide as, for display.

#include <optional>

#include "common/mesh.h"
#include "common/scene/scene.h"

namespace prosector {

/// Returns the outline of a rigid body's collision shape, in the body's frame, where it is not its surface: a
/// hull, or the sphere or box around it. A box along the room's axes is that of the body in its initial pose.
std::optional<TriangleMesh> collision_outline(const RigidDesc& body, const TriangleMesh& surface);

}  // namespace prosector
