#pragma once
// Parser of terminal commands on the display of parts.

#include <optional>
#include <string>
#include <variant>

#include "client/view/parts_rows.h"

namespace prosector {

/// Returns an order, or a text for the terminal (a list of parts, or an error); nullopt: the line is none of
/// these commands. Parts are named in any language; for `parts`, other text is searched for as in the list.
std::optional<std::variant<PartsOrder, std::string>> parse_parts_line(const std::string& line,
                                                                      const PartsData& known,
                                                                      const PartsChoice& choice);

}  // namespace prosector
