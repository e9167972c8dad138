#include "common/surface_files.h"

#include "common/file_endings.h"

namespace prosector {

bool is_surface_file(std::string_view file) {
  return has_ending(file, surface_endings);
}

}  // namespace prosector
