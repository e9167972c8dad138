#pragma once
// Look-up functions for untrusted JSON, in which any element may be missing.

#include <nlohmann/json.hpp>
#include <optional>

#include "common/math.h"

namespace prosector {

/// Returns the value of a key of a JSON object; JSON null if the key is missing or `json` is not an object.
inline const nlohmann::json& json_at(const nlohmann::json& json, const char* key) {
  static const nlohmann::json nothing;
  const auto found = json.find(key);
  return found == json.end() ? nothing : *found;
}

/// Converts a JSON array of three numbers to a vector. Returns nothing for any other JSON value.
inline std::optional<Vec3> json_vector(const nlohmann::json& json) {
  if (!json.is_array() || json.size() != 3) return std::nullopt;
  Vec3 out;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!json[i].is_number()) return std::nullopt;
    out[static_cast<int>(i)] = json[i].get<double>();
  }
  return out;
}

}  // namespace prosector
