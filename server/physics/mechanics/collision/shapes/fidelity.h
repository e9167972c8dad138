#pragma once
// Names of the collision fidelities.

#include <array>
#include <string_view>

#include "common/fidelity.h"

namespace prosector {

/// Indexed by Fidelity (common/messages.h), coarsest first. rigid_outline.h and proxy_shape.h describe the
/// shapes.
inline constexpr std::array<std::string_view, 6> fidelity_names = {"none", "sphere", "aabb",
                                                                   "obb",  "hull",   "mesh"};
constexpr std::string_view fidelity_name(Fidelity fidelity) {
  return fidelity_names[static_cast<std::size_t>(fidelity)];
}
/// Returns whether the shape at this fidelity is nearly round and rolls as a whole.
constexpr bool rolls(Fidelity fidelity) {
  return fidelity == Fidelity::sphere || fidelity == Fidelity::hull;
}
/// Returns the fidelity of this name. Throws InputError for an unknown name and lists the valid names.
Fidelity fidelity_of(std::string_view name);

}  // namespace prosector
