#pragma once
// Role names as users type and read them.

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "common/ids.h"

namespace prosector {

inline constexpr std::array<const char*, 3> role_words = {"observer", "dissector", "host"};  // by Role

inline const char* role_word(Role role) {
  return role_words[static_cast<std::size_t>(role)];
}
inline std::optional<Role> role_of(std::string_view word) {
  const auto found = std::find(role_words.begin(), role_words.end(), word);
  if (found == role_words.end()) return std::nullopt;
  return static_cast<Role>(found - role_words.begin());
}

}  // namespace prosector
