#pragma once
// How finely an object's shape is taken for collision.

#include <array>
#include <string_view>

#include "common/messages.h"

namespace prosector {

/// By Fidelity (common/messages.h), coarsest first. What each is: rigid_outline.h, rough_shape.h.
inline constexpr std::array<std::string_view, 6> fidelity_names = {"none", "sphere", "aabb",
                                                                   "obb",  "hull",   "mesh"};
constexpr std::string_view fidelity_name(Fidelity fidelity) {
  return fidelity_names[static_cast<std::size_t>(fidelity)];
}
/// Returns whether what collides so is round, or nearly, and rolls as a whole.
constexpr bool rolls(Fidelity fidelity) {
  return fidelity == Fidelity::sphere || fidelity == Fidelity::hull;
}
/// Throws InputError that lists the names.
Fidelity fidelity_of(std::string_view name);

}  // namespace prosector
