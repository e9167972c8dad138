#pragma once
// Parser of terminal commands on the display of parts.

#include <optional>
#include <string>
#include <variant>

#include "client/view/parts_rows.h"

namespace prosector {

/// Parses a terminal command on the display of parts. Returns an order (command that changes this viewer's
/// display of parts), or a text for the terminal (a list of parts, or an error). Returns nullopt if the line
/// is none of these commands. Parts are named in any language; for `parts`, other text is searched for as in
/// the list.
std::optional<std::variant<PartsOrder, std::string>> parse_parts_line(const std::string& line,
                                                                      const PartsData& known,
                                                                      const PartsChoice& choice);

}  // namespace prosector
