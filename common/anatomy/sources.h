#pragma once
// Makes the geometry of a body from its description in a scene: files found, meshed, cached.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "common/anatomy/mask.h"
#include "common/mesh.h"
#include "common/scene/scene.h"

namespace prosector {

/// Where files that a scene names are looked for, in this order, and where results are kept.
struct SourcePaths {
  std::filesystem::path scene_dir;
  std::vector<std::filesystem::path> data_dirs;
  std::filesystem::path cache_dir;  // empty: no cache
};

/// Makes tetrahedra and the embedded surface in the world frame. A missing file is replaced by
/// desc.fallback, and `progress` says so; without a fallback InputError lists where it was looked for.
Anatomy make_anatomy(const SoftDesc& desc, const SourcePaths& paths, const Progress& progress);

/// Makes the surface of a rigid body in its own frame: its mesh, scaled and thinned, or its parts.
TriangleMesh make_surface(const RigidDesc& desc, const SourcePaths& paths, const Progress& progress);

}  // namespace prosector
