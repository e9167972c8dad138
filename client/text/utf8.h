#pragma once
// UTF-8 as characters, and back.

#include <string>
#include <string_view>

namespace prosector {

inline constexpr char32_t replacement_character = 0xFFFD;

/// Returns the characters of a text that may hold anything. Each ill-formed part, and each control character
/// but '\n' and '\t', becomes U+FFFD. The '\r' of "\r\n" is left out.
std::u32string characters_of(std::string_view utf8);

/// Returns the characters as UTF-8; surrogates and what lies beyond U+10FFFF become U+FFFD.
std::string utf8_of(std::u32string_view characters);

}  // namespace prosector
