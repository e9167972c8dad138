#include "common/file_endings.h"

#include <algorithm>

namespace prosector {

bool has_ending(std::string_view file, std::span<const std::string_view> endings) {
  const auto same = [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; };
  return std::ranges::any_of(endings, [&](std::string_view ending) {
    return file.size() >= ending.size() &&
           std::ranges::equal(file.substr(file.size() - ending.size()), ending, same);
  });
}

}  // namespace prosector
