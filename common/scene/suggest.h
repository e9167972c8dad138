#pragma once
// Spelling suggestions for unknown words.

#include <span>
#include <string>
#include <string_view>

namespace prosector {

/// Returns `; did you mean "cell"?`, or the list of known words if none is similar.
std::string suggest(std::string_view word, std::span<const std::string_view> known);

}  // namespace prosector
