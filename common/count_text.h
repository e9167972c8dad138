#pragma once
// Counts formatted as text.

#include <cstdint>
#include <string>
#include <string_view>

namespace prosector {

/// Returns a count with the noun `what` as text, for nouns with a plural in s: "1 step", "0 steps", "20
/// steps".
inline std::string counted(std::uint64_t n, std::string_view what) {
  return std::to_string(n) + ' ' + std::string(what) + (n == 1 ? "" : "s");
}

}  // namespace prosector
