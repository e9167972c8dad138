#include "common/anatomy/search_paths.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/regular_file.h"

namespace prosector {
namespace {

std::vector<std::filesystem::path> candidates(const std::string& file, const SourcePaths& paths) {
  if (std::filesystem::path(file).is_absolute()) return {file};
  std::vector<std::filesystem::path> out = {paths.scene_dir / file};
  for (const auto& dir : paths.data_dirs) out.push_back(dir / file);
  return out;
}

}  // namespace

std::filesystem::path find_source(const std::string& file, const SourcePaths& paths) {
  const auto places = candidates(file, paths);
  std::error_code unreadable;
  for (const auto& path : places)
    if (std::filesystem::is_regular_file(path, unreadable)) return path;
  if (!file.empty()) std::ranges::for_each(places, require_regular_file);
  return {};
}

std::string missing_source(const std::string& file, const SourcePaths& paths) {
  std::string looked;
  for (const auto& path : candidates(file, paths)) looked += (looked.empty() ? "" : ", ") + path.string();
  return fmt::format(
      "{} is missing; searched for {}. Fetch it (files of the shipped scenes: deploy/fetch_anatomy.sh)", file,
      looked);
}

}  // namespace prosector
