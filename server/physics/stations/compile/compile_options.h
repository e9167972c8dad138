#pragma once
// Options of scene compilation.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "common/mesh.h"
#include "common/scene/scene.h"

namespace prosector {

/// Folders of a scene's files, and number of threads for compiling and stepping.
struct CompileOptions {
  int threads = 0;  // 0: all cores
  /// Folders in which sources named in the scene are searched, after the scene's own folder.
  std::vector<std::filesystem::path> data_dirs;
  std::filesystem::path cache_dir;  // cache of meshes and equilibria by content hash; empty: none
  std::function<void(const std::string&)> progress;  // called with user-readable progress lines
  /// Returns geometry (world frame) of a soft body to use instead of the scene's source, or none.
  std::function<std::optional<Anatomy>(const SoftDesc&)> anatomy;
};

}  // namespace prosector
