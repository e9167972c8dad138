#pragma once
// Where files that a scene names are found.

#include <filesystem>
#include <string>
#include <vector>

namespace prosector {

/// Where files that a scene names are looked for, in this order, and where results are kept.
struct SourcePaths {
  std::filesystem::path scene_dir;
  std::vector<std::filesystem::path> data_dirs;
  std::filesystem::path cache_dir;  // empty: no cache
};

/// Finds the first place that has the file; empty: none has. Throws InputError where none has it but one
/// holds a folder, a pipe or a device of that name.
std::filesystem::path find_source(const std::string& file, const SourcePaths& paths);

/// Returns what to say of a file that no place has: where it was looked for, and how to get it.
std::string missing_source(const std::string& file, const SourcePaths& paths);

}  // namespace prosector
