#pragma once
// Which parts of a rigid body or hand may be near a place: a hand has fifteen, and most are far from any.

#include <cstdint>
#include <vector>

#include "common/math.h"

namespace prosector {

struct Collider;

class PartBoxes {
 public:
  /// Puts a box around each of the collider's parts, world frame, grown by `margin` (m).
  PartBoxes(const Collider& collider, double margin);

  /// Returns the parts, ascending, whose boxes meet the one from lo to hi: what is in there is farther than
  /// the margin from all others. Valid until the next call.
  const std::vector<std::uint32_t>& meeting(const Vec3& lo, const Vec3& hi);

 private:
  struct Box {
    Vec3 lo, hi;  // m
  };
  std::vector<Box> boxes_;  // by part
  std::vector<std::uint32_t> found_;
};

}  // namespace prosector
