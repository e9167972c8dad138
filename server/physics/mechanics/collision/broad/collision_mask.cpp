#include "server/physics/mechanics/collision/broad/collision_mask.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>

#include "common/error.h"

namespace prosector::collision {

constexpr auto most_groups = static_cast<std::size_t>(std::numeric_limits<std::uint32_t>::digits);

CollisionGroups::CollisionGroups() : names_{"default"} {}

void CollisionGroups::add(std::string_view name) {
  if (name.empty()) throw InputError("collision group: the name is empty");
  if (std::find(names_.begin(), names_.end(), name) != names_.end())
    throw InputError(fmt::format("collision group \"{}\" is defined twice", name));
  if (names_.size() == most_groups)
    throw InputError(fmt::format(
        "collision group \"{}\": {} groups exist already, \"default\" included, which is the maximum", name,
        most_groups));
  names_.emplace_back(name);
}

CollisionMask CollisionGroups::mask(std::string_view group, std::span<const std::string> touches) const {
  CollisionMask out{bit(group), touches.empty() ? ~0u : 0u};
  for (const std::string& name : touches) out.mask |= bit(name);
  return out;
}

std::uint32_t CollisionGroups::bit(std::string_view name) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found == names_.end())
    throw InputError(
        fmt::format("collision group \"{}\" does not exist; defined: {}", name, fmt::join(names_, ", ")));
  return 1u << (found - names_.begin());
}

}  // namespace prosector::collision
