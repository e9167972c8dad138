#pragma once
// Construction of a body's geometry from its scene description: finds files, meshes them, uses the cache.

#include "common/anatomy/mask.h"
#include "common/anatomy/search_paths.h"
#include "common/mesh.h"
#include "common/scene/scene.h"

namespace prosector {

/// Builds a soft body's tetrahedra and embedded surface in the world frame from the source in its
/// description. A missing file is replaced by desc.fallback and reported to `progress`. Without a fallback,
/// throws InputError that lists the searched directories.
Anatomy make_anatomy(const SoftDesc& desc, const SourcePaths& paths, const Progress& progress);

/// Builds the surface of a rigid body in the body's own frame from its description: its mesh file, scaled and
/// simplified, or its parts.
TriangleMesh make_surface(const RigidDesc& desc, const SourcePaths& paths, const Progress& progress);

}  // namespace prosector
