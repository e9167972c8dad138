#pragma once
// Bounding boxes of the parts of a rigid body or hand, to find the few parts near a place: a hand has
// fifteen.

#include <cstdint>
#include <vector>

#include "common/math.h"

namespace prosector {

struct Collider;

/// World-frame bounding boxes of a collider's parts.
class PartBoxes {
 public:
  /// Builds a box around each of the collider's parts, grown by `margin` (m).
  PartBoxes(const Collider& collider, double margin);

  /// Returns the parts, ascending, whose boxes overlap the box from lo to hi. All other parts are farther
  /// than the margin from any point in there. Valid until the next call.
  const std::vector<std::uint32_t>& meeting(const Vec3& lo, const Vec3& hi);

 private:
  struct Box {
    Vec3 lo, hi;  // m
  };
  std::vector<Box> boxes_;  // by part
  std::vector<std::uint32_t> found_;
};

}  // namespace prosector
