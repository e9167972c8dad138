#include "server/physics/collision/collision_mask.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "common/error.h"

namespace prosector {

constexpr std::size_t most_groups = 32;  // bits of a mask

CollisionGroups::CollisionGroups() : names_{"default"} {}

void CollisionGroups::add(std::string_view name) {
  if (name.empty()) throw InputError("collision group: the name is empty");
  if (std::find(names_.begin(), names_.end(), name) != names_.end())
    throw InputError(fmt::format("collision group \"{}\" is there twice", name));
  if (names_.size() == most_groups)
    throw InputError(
        fmt::format("collision group \"{}\": there are {} already, \"default\" included; no more fit", name,
                    most_groups));
  names_.emplace_back(name);
}

CollisionMask CollisionGroups::mask(std::span<const std::string> groups,
                                    std::span<const std::string> touches) const {
  CollisionMask out;
  if (!groups.empty()) out.group = bits(groups);
  if (!touches.empty()) out.mask = bits(touches);
  return out;
}

std::uint32_t CollisionGroups::bits(std::span<const std::string> names) const {
  std::uint32_t out = 0;
  for (const std::string& name : names) {
    const auto found = std::find(names_.begin(), names_.end(), name);
    if (found == names_.end())
      throw InputError(
          fmt::format("collision group \"{}\" is not there; there are {}", name, fmt::join(names_, ", ")));
    out |= 1u << (found - names_.begin());
  }
  return out;
}

}  // namespace prosector
