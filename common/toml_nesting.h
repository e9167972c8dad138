#pragma once
// What a TOML text must not hold, found before it is parsed. How deep it nests: the parser and what it makes
// recurse. A header without a name, letters beyond ASCII outside quotes: the parser takes for granted that
// there are none.

#include <string>
#include <string_view>

namespace prosector {

/// Levels of tables and lists in one another that a file may have; the deepest field of a scene has five.
inline constexpr int max_toml_nesting = 32;

/// Throws InputError with `file` and the line where a key has more parts, or brackets are nested deeper, than
/// `max_toml_nesting`. So it does where a table has no name, or what isn't ASCII stands outside quotes and
/// comments. Reads no further into what isn't TOML than its strings and comments.
void check_nesting(std::string_view toml, const std::string& file);

}  // namespace prosector
