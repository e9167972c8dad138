#pragma once
// Makes the geometry of a body from its description in a scene: files found, meshed, cached.

#include "common/anatomy/mask.h"
#include "common/anatomy/source_paths.h"
#include "common/mesh.h"
#include "common/scene/scene.h"

namespace prosector {

/// Makes tetrahedra and the embedded surface in the world frame. A missing file is replaced by
/// desc.fallback, and `progress` says so; without a fallback InputError lists where it was looked for.
Anatomy make_anatomy(const SoftDesc& desc, const SourcePaths& paths, const Progress& progress);

/// Makes the surface of a rigid body in its own frame: its mesh, scaled and thinned, or its parts.
TriangleMesh make_surface(const RigidDesc& desc, const SourcePaths& paths, const Progress& progress);

}  // namespace prosector
