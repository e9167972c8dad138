#include "tests/folders.h"

namespace prosector {

std::string source_path(std::string_view inside) {
  return std::string(PROSECTOR_SOURCE_FOLDER "/").append(inside);
}

std::string build_path(std::string_view inside) {
  return std::string(PROSECTOR_BUILD_FOLDER "/").append(inside);
}

}  // namespace prosector
