#pragma once
// How deep a TOML text nests, found before it is parsed: the parser and what it makes recurse.

#include <string>
#include <string_view>

namespace prosector {

/// Levels of tables and lists in one another that a file may have; the deepest field of a scene has five.
inline constexpr int max_toml_nesting = 32;

/// Throws InputError with `file` and the line where a key has more parts, or brackets are nested deeper, than
/// `max_toml_nesting`. Reads no further into what isn't TOML than its strings and comments.
void check_nesting(std::string_view toml, const std::string& file);

}  // namespace prosector
