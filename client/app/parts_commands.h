#pragma once
// What a person types at the client's terminal about what they see of the parts.

#include <optional>
#include <string>
#include <variant>

#include "client/view/parts_rows.h"

namespace prosector {

/// Returns an order, or words for the terminal (a list of parts, or why it is no order); nullopt: the line is
/// none of these commands. Parts are named in any language; what no part is called searches as the list does.
std::optional<std::variant<PartsOrder, std::string>> parse_parts_line(const std::string& line,
                                                                      const PartsKnown& known,
                                                                      const PartsChoice& choice);

}  // namespace prosector
