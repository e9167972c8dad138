#pragma once
// Checks of a TOML text before it is parsed. Deep nesting is refused because toml++ and its result recurse.
// Table headers without a name and non-ASCII text outside quotes are refused because the parser assumes that
// there are none.

#include <string>
#include <string_view>

namespace prosector {

/// Maximum nesting depth of tables and arrays in a TOML file; the deepest field of a scene is at depth five.
inline constexpr int max_toml_nesting = 32;

/// Checks a TOML text before it is parsed. Throws InputError with `file` and the line of the first violation.
/// Violations are keys with more parts, or brackets nested deeper, than `max_toml_nesting`, table headers
/// without a name, and non-ASCII characters outside strings and comments. Interprets only brackets, keys,
/// strings and comments.
void check_nesting(std::string_view toml, const std::string& file);

}  // namespace prosector
