#pragma once
// Disk cache of finished meshes, named by the hash of their source.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "common/hash.h"
#include "common/mesh.h"

namespace prosector {

struct CachedAnatomy {
  Anatomy anatomy;
  std::vector<std::string> remarks;  // warnings and notes to report each time the mesh is used
  double expected_volume = 0;        // m³: volume enclosed or labelled in the source file; 0: unknown
};

/// Result of looking up a mesh in the disk cache: the mesh, or none and the reason ("" if there is no cached
/// file). Without a mesh, the caller builds it from its source.
struct CachedAnatomyResult {
  std::optional<CachedAnatomy> made;
  std::string error;
};
CachedAnatomyResult load_cached(const std::filesystem::path& dir, const ContentHash& key);

/// Stores the mesh in the cache directory `dir` under its key. Writes a temporary file and renames it, so
/// that readers never see a partial file. Returns false if the folder isn't writable, which is not an error
/// for a cache.
bool store_cached(const std::filesystem::path& dir, const ContentHash& key, const CachedAnatomy& made);

}  // namespace prosector
