#pragma once
// Finished meshes on disk, named by the hash of what they were made from.

#include <filesystem>
#include <optional>
#include <string>

#include "common/hash.h"
#include "common/mesh.h"

namespace prosector {

struct CachedAnatomy {
  Anatomy anatomy;
  std::string warning;  // what its author should know each time that it is used; empty when all is well
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
