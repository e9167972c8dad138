#pragma once
// Spelling suggestions for unknown words.

#include <span>
#include <string>
#include <string_view>

namespace prosector {

/// Returns a hint for a word that is not among `known`, to be appended to a message: `; did you mean "cell"?`
/// with the most similar word. If none is similar, it lists the known words.
std::string suggest(std::string_view word, std::span<const std::string_view> known);

}  // namespace prosector
