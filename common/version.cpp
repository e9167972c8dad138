#include "common/version.h"

#include <fmt/format.h>

namespace prosector {

std::string version_line(std::string_view program) {
  return fmt::format("{} {}", program, PROSECTOR_VERSION);
}

}  // namespace prosector
