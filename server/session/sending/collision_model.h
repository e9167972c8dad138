#pragma once
// Outlines of the shapes that bodies collide as, for display.

#include <optional>

#include "common/mesh.h"
#include "common/scene/scene.h"

namespace prosector {

/// Returns the outline of a rigid body's collision shape in the body's frame, if that shape is not its
/// surface: a hull, or a sphere or box around the body. A box along the room's axes is that of the body in
/// its initial pose. Returns nullopt if the body collides as its surface or not at all.
std::optional<TriangleMesh> collision_outline(const RigidDesc& body, const TriangleMesh& surface);

}  // namespace prosector
