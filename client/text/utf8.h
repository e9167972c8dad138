#pragma once
// Conversion between UTF-8 and characters.

#include <string>
#include <string_view>

namespace prosector {

inline constexpr char32_t replacement_character = 0xFFFD;

/// Converts UTF-8 to Unicode characters. Each ill-formed sequence, and each control character except '\n' and
/// '\t', becomes U+FFFD. The '\r' of "\r\n" is removed.
std::u32string characters_of(std::string_view utf8);

/// Converts Unicode characters to UTF-8. Surrogates and values above U+10FFFF become U+FFFD.
std::string utf8_of(std::u32string_view characters);

}  // namespace prosector
