#include "common/surface_files.h"

#include <algorithm>

namespace prosector {

bool is_surface_file(std::string_view file) {
  const auto same = [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; };
  return std::ranges::any_of(surface_endings, [&](std::string_view ending) {
    return file.size() >= ending.size() &&
           std::ranges::equal(file.substr(file.size() - ending.size()), ending, same);
  });
}

}  // namespace prosector
