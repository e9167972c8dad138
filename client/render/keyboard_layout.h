#pragma once
// Key names on keyboards other than a US one.

#include <cctype>
#include <string_view>

#include "client/render/window_context.h"

namespace prosector {

/// Returns the key that a user means by pressing the key at the position `place` of a US keyboard. `printed`
/// is the character of that key in the user's layout (UTF-8, lower case; empty: unknown). W A S D Q E form a
/// cross for the fingers, so the position counts. For other letters, plus and minus the printed character
/// counts; plus is '=', as on a US keyboard.
inline Key key_meant(Key place, std::string_view printed) {
  constexpr std::string_view cross = "WASDQE";
  const auto in_cross = [&](Key key) {
    return static_cast<int>(key) < 128 && cross.find(static_cast<char>(key)) != std::string_view::npos;
  };
  if (printed.size() != 1 || in_cross(place)) return place;
  const char sign = printed.front();
  if (sign == '+' || sign == '=') return key_of('=');
  if (sign == '-') return key_of('-');
  if (std::isalpha(static_cast<unsigned char>(sign)) == 0) return place;
  const Key letter = key_of(static_cast<char>(std::toupper(static_cast<unsigned char>(sign))));
  return in_cross(letter) ? place : letter;
}

}  // namespace prosector
