#pragma once
// Sources of a scene's geometry.

#include "server/physics/stations/compile/compile_options.h"

namespace prosector {

/// Returns the scene completed from the label files that it names: the bodies of its atlases, and body names
/// in several languages. Throws InputError if a file is missing or invalid.
SceneDesc whole_scene(const SceneDesc& scene, const CompileOptions& options);

/// Creates a rigid body's surface mesh in the body's own frame from the geometry source in its description.
/// Throws InputError if the source is missing or invalid.
TriangleMesh rigid_surface(const RigidDesc& desc, const SceneDesc& scene, const CompileOptions& options);

/// Creates a soft body's meshes in the world frame from the geometry source in its description. The mesh is
/// finer at attachment rims if the description requests it. Throws InputError if the source is missing or
/// invalid.
Anatomy soft_anatomy(const SoftDesc& desc, const SceneDesc& scene, const CompileOptions& options);

}  // namespace prosector
