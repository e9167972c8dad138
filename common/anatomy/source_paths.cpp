#include "common/anatomy/source_paths.h"

#include <fmt/format.h>

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
  for (const auto& path : candidates(file, paths))
    if (std::filesystem::is_regular_file(path)) return path;
  return {};
}

std::string missing_source(const std::string& file, const SourcePaths& paths) {
  std::string looked;
  for (const auto& path : candidates(file, paths)) looked += (looked.empty() ? "" : ", ") + path.string();
  return fmt::format(
      "{} is missing; looked for {}. Fetch it (what shipped scenes need: deploy/fetch_anatomy.sh)", file,
      looked);
}

}  // namespace prosector
