#include "client/render/shader_dir.h"

#include <cstdlib>

namespace prosector {

std::filesystem::path default_shader_dir() {
  const char* chosen = std::getenv("PROSECTOR_SHADERS");
  return chosen == nullptr ? std::filesystem::path() : std::filesystem::path(chosen);
}

}  // namespace prosector
