#pragma once
// Collision filter, the first of the three collision stages: which groups of objects may collide.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace prosector::collision {

/// Collision filter of an object as bit masks: its group, and the groups with which it may collide. By
/// default an object is in the first group and collides with all groups.
struct CollisionMask {
  std::uint32_t group = 1;   // the group of the object
  std::uint32_t mask = ~0u;  // the groups the object collides with
};

/// Returns whether two objects may collide: each one's mask must include the other's group.
constexpr bool may_touch(const CollisionMask& a, const CollisionMask& b) {
  return (a.group & b.mask) != 0 && (b.group & a.mask) != 0;
}

/// Names of a scene's collision groups, at most 32. The names are assigned the bits of CollisionMask in the
/// order in which they are added.
class CollisionGroups {
 public:
  /// Creates the list with one group, "default".
  CollisionGroups();
  /// Adds a collision group and assigns it the next free bit. Throws InputError for an empty or duplicate
  /// name, and when all 32 bits are in use.
  void add(std::string_view name);
  /// Returns the collision mask of an object in `group` that collides with the groups `touches`; an empty
  /// `touches` means all groups. Throws InputError for an unknown group name; the message lists the known
  /// names.
  CollisionMask mask(std::string_view group, std::span<const std::string> touches) const;
  std::span<const std::string> names() const { return names_; }

 private:
  std::uint32_t bit(std::string_view name) const;
  std::vector<std::string> names_;
};

}  // namespace prosector::collision
