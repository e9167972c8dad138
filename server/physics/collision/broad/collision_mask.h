#pragma once
// Who may touch whom: the first of the three stages.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace prosector {

/// Bits of named groups. By default an object is in the first group and touches all.
struct CollisionMask {
  std::uint32_t group = 1;   // the group that it belongs to
  std::uint32_t mask = ~0u;  // the groups that it touches
};

/// Tells whether each is willing to touch the other.
constexpr bool may_touch(const CollisionMask& a, const CollisionMask& b) {
  return (a.group & b.mask) != 0 && (b.group & a.mask) != 0;
}

/// The names of a scene's groups, as many as bits; each gets the next bit.
class CollisionGroups {
 public:
  /// Starts with the group "default".
  CollisionGroups();
  /// Throws InputError for an empty or doubled name and when 32 are taken.
  void add(std::string_view name);
  /// Returns the mask of a group. `touches` empty: all. Throws InputError for a name that isn't there,
  /// listing those that are.
  CollisionMask mask(std::string_view group, std::span<const std::string> touches) const;
  std::span<const std::string> names() const { return names_; }

 private:
  std::uint32_t bit(std::string_view name) const;
  std::vector<std::string> names_;
};

}  // namespace prosector
