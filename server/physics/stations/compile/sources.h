#pragma once
// Sources of a scene's geometry.

#include "server/physics/stations/compile/compile_options.h"

namespace prosector {

/// Returns the scene, completed from its label files: bodies of its atlases, names in languages. Throws
/// InputError.
SceneDesc whole_scene(const SceneDesc& scene, const CompileOptions& options);

/// Creates a rigid body's surface in its own frame. Throws InputError.
TriangleMesh rigid_surface(const RigidDesc& desc, const SceneDesc& scene, const CompileOptions& options);

/// Creates a soft body's mesh in the world frame, graded if the scene says so. Throws InputError.
Anatomy soft_anatomy(const SoftDesc& desc, const SceneDesc& scene, const CompileOptions& options);

}  // namespace prosector
