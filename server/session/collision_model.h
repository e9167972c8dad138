#pragma once
// What bodies collide as, for people to see.

#include <optional>

#include "common/mesh.h"
#include "common/messages.h"
#include "common/scene/scene.h"

namespace prosector {

/// Returns the outline that a rigid body collides as, in its own frame, where that is not its surface: a
/// hull, or the sphere or box around it. The box along the room's axes is that of the body as the scene
/// places it.
std::optional<TriangleMesh> collision_outline(const RigidDesc& body, const TriangleMesh& surface);

}  // namespace prosector
