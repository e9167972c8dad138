#pragma once
// Validation of names and of texts shown to users.

#include <string_view>

namespace prosector {

/// Returns whether the bytes are valid UTF-8 (RFC 3629).
bool valid_utf8(std::string_view text);
/// Returns whether the name is 1 … max_name_length bytes of UTF-8 without control characters.
bool valid_name(std::string_view name);
/// Returns whether the text is at most max_text_length bytes of UTF-8 whose only control characters are line
/// feed and tab.
bool valid_text(std::string_view text);

}  // namespace prosector
