#pragma once
// Numbers of things in words for people.

#include <cstdint>
#include <string>
#include <string_view>

namespace prosector {

/// Returns "1 step", "0 steps", "20 steps", for words whose plural takes an s.
inline std::string counted(std::uint64_t n, std::string_view what) {
  return std::to_string(n) + ' ' + std::string(what) + (n == 1 ? "" : "s");
}

}  // namespace prosector
