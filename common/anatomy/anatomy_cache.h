#pragma once
// Finished meshes on disk, named by the hash of what they were made from.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "common/hash.h"
#include "common/mesh.h"

namespace prosector {

struct CachedAnatomy {
  Anatomy anatomy;
  std::vector<std::string> remarks;  // what its author should read each time that it is used
  double expected_volume = 0;        // m³: what its file encloses or labels; 0: not known
};

/// What was found: a mesh, or none and why not ("" where there was none): the caller builds anew.
struct FoundAnatomy {
  std::optional<CachedAnatomy> made;
  std::string trouble;
};
FoundAnatomy load_cached(const std::filesystem::path& dir, const ContentHash& key);

/// Stores the mesh under its key, written aside and renamed, so that readers see all or nothing. Returns
/// false when the folder can't be written: a cache is no reason to fail.
bool store_cached(const std::filesystem::path& dir, const ContentHash& key, const CachedAnatomy& made);

}  // namespace prosector
