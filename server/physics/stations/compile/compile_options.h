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

/// Options for compiling a scene: folders of its files, the cache, the number of threads, and callbacks.
struct CompileOptions {
  int threads = 0;  // 0: all cores
  /// Folders in which sources named in the scene are searched, after the scene's own folder.
  std::vector<std::filesystem::path> data_dirs;
  std::filesystem::path cache_dir;  // cache of meshes and equilibria by content hash; empty: none
  std::function<void(const std::string&)> progress;  // called with user-readable progress lines
  /// Function that returns a soft body's geometry (world frame), to use instead of the source that the scene
  /// names. It returns none for a body whose source in the scene is to be used. May be empty.
  std::function<std::optional<Anatomy>(const SoftDesc&)> anatomy;
};

}  // namespace prosector
