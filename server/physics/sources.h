#pragma once
// Where a scene's geometry comes from.

#include "server/physics/simulation.h"

namespace prosector {

/// Returns the scene with what it says by naming files of labels: bodies of its atlases, names in languages.
/// Throws InputError.
SceneDesc whole_scene(const SceneDesc& scene, const CompileOptions& options);

/// Makes a rigid body's surface in its own frame. Throws InputError.
TriangleMesh rigid_surface(const RigidDesc& desc, const SceneDesc& scene, const CompileOptions& options);

/// Makes a soft body's mesh in the world frame, graded where the scene says so. Throws InputError.
Anatomy soft_anatomy(const SoftDesc& desc, const SceneDesc& scene, const CompileOptions& options);

}  // namespace prosector
