#pragma once
// Bounding boxes of the parts of a rigid body or hand, to find the few parts near a place: a hand has
// fifteen.

#include <cstdint>
#include <vector>

#include "common/math.h"

namespace prosector::contact {

struct Collider;

/// Bounding boxes of the parts of a rigid body or hand, aligned with the world axes, to find the parts close
/// to a region.
class PartBoxes {
 public:
  /// Computes a box around each of the collider's parts, enlarged by `margin` (m) on each side.
  PartBoxes(const Collider& collider, double margin);

  /// Returns the indices, ascending, of the parts whose enlarged boxes overlap the box from lo to hi (m,
  /// world frame). All other parts are farther than the margin from every point of that box. The reference is
  /// valid until the next call.
  const std::vector<std::uint32_t>& meeting(const Vec3& lo, const Vec3& hi);

 private:
  struct Box {
    Vec3 lo, hi;  // m
  };
  std::vector<Box> boxes_;  // by part
  std::vector<std::uint32_t> found_;
};

}  // namespace prosector::contact
