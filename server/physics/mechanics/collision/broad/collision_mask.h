#pragma once
// Collision filter, the first of the three collision stages: which groups of objects may collide.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace prosector {

/// Bit masks of named collision groups. By default an object is in the first group and collides with all
/// groups.
struct CollisionMask {
  std::uint32_t group = 1;   // the group of the object
  std::uint32_t mask = ~0u;  // the groups the object collides with
};

/// Returns whether the masks of both objects allow a collision.
constexpr bool may_touch(const CollisionMask& a, const CollisionMask& b) {
  return (a.group & b.mask) != 0 && (b.group & a.mask) != 0;
}

/// Names of a scene's collision groups, at most 32. Each name is assigned the next free bit.
class CollisionGroups {
 public:
  /// Starts with the group "default".
  CollisionGroups();
  /// Adds a group. Throws InputError for an empty or duplicate name, and when all 32 bits are in use.
  void add(std::string_view name);
  /// Returns the mask of a group that collides with the groups `touches`; empty: with all. Throws InputError
  /// for an unknown name and lists the known names.
  CollisionMask mask(std::string_view group, std::span<const std::string> touches) const;
  std::span<const std::string> names() const { return names_; }

 private:
  std::uint32_t bit(std::string_view name) const;
  std::vector<std::string> names_;
};

}  // namespace prosector
