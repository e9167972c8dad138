#pragma once
// Search paths for files that a scene refers to.

#include <filesystem>
#include <string>
#include <vector>

namespace prosector {

/// Directories in which files of a scene are searched, in this order, and the cache directory.
struct SourcePaths {
  std::filesystem::path scene_dir;
  std::vector<std::filesystem::path> data_dirs;
  std::filesystem::path cache_dir;  // empty: no cache
};

/// Returns the path of a file that a scene refers to, in the first search directory that has it; empty if
/// none has. Throws InputError if none has it but one has a folder, pipe or device of that name.
std::filesystem::path find_source(const std::string& file, const SourcePaths& paths);

/// Returns the error message for a missing file that a scene refers to: the directories searched, and how to
/// get the file.
std::string missing_source(const std::string& file, const SourcePaths& paths);

}  // namespace prosector
