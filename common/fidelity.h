#pragma once
// How finely a body collides.

#include <array>
#include <cstdint>
#include <string_view>

namespace prosector {

/// Collision shape of a body, coarsest first (docs/understand/collision.md).
enum class Fidelity : std::uint8_t { none, sphere, aabb, obb, hull, mesh };

/// Names of the collision shapes in scene files, indexed by Fidelity.
inline constexpr std::array<std::string_view, 6> fidelity_names = {"none", "sphere", "aabb",
                                                                   "obb",  "hull",   "mesh"};
constexpr std::string_view fidelity_name(Fidelity fidelity) {
  return fidelity_names[static_cast<std::size_t>(fidelity)];
}
/// Returns whether a body with this collision shape is nearly round and rolls as a whole.
constexpr bool rolls(Fidelity fidelity) {
  return fidelity == Fidelity::sphere || fidelity == Fidelity::hull;
}

}  // namespace prosector
