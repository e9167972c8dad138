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
  std::uint32_t group = 1;   // the groups that it belongs to
  std::uint32_t mask = ~0u;  // the groups that it touches
};

/// Each must be willing to touch the other.
constexpr bool may_touch(const CollisionMask& a, const CollisionMask& b) {
  return (a.group & b.mask) != 0 && (b.group & a.mask) != 0;
}

/// The names of a scene's groups, at most 32; each gets the next bit.
class CollisionGroups {
 public:
  /// "default" is there from the start.
  CollisionGroups();
  /// Throws InputError for an empty or doubled name and when 32 are taken.
  void add(std::string_view name);
  /// `groups` and `touches` by name; an empty list means the default: "default", and all. Throws InputError
  /// for a name that isn't there, listing those that are.
  CollisionMask mask(std::span<const std::string> groups, std::span<const std::string> touches) const;
  std::span<const std::string> names() const { return names_; }

 private:
  std::uint32_t bits(std::span<const std::string> names) const;
  std::vector<std::string> names_;
};

}  // namespace prosector
