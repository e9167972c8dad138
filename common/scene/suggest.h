#pragma once
// The nearest known word to a mistyped one.

#include <span>
#include <string>
#include <string_view>

namespace prosector {

/// Returns `; did you mean "cell"?` or, when nothing is near, the list of what is known.
std::string suggest(std::string_view word, std::span<const std::string_view> known);

}  // namespace prosector
