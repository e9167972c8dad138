#include "client/render/shader_dir.h"

#include <fmt/format.h>

#include <cstdlib>

#include "common/error.h"

namespace prosector {

std::filesystem::path default_shader_dir() {
  if (const char* chosen = std::getenv("PROSECTOR_SHADERS")) return chosen;
  const std::filesystem::path source_tree = PROSECTOR_SOURCE_SHADERS, installed = PROSECTOR_INSTALLED_SHADERS;
  for (const auto& folder : {source_tree, installed})
    if (std::filesystem::is_directory(folder)) return folder;
  throw InputError(fmt::format("no shaders in {} or {}; set PROSECTOR_SHADERS to the folder with main.frag",
                               source_tree.string(), installed.string()));
}

}  // namespace prosector
