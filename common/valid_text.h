#pragma once
// What may stand in a name, or in a text for people.

#include <string_view>

namespace prosector {

/// Tells whether the bytes are UTF-8 (RFC 3629).
bool valid_utf8(std::string_view text);
/// Tells whether it is 1 … max_name_length bytes of UTF-8 without control characters.
bool valid_name(std::string_view name);
/// Tells whether it is at most max_text_length bytes of UTF-8; no control characters but line feed and tab.
bool valid_text(std::string_view text);

}  // namespace prosector
