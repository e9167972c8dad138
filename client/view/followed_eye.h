#pragma once
// An eye that is followed while it is seen, and eases to its resting place while it isn't.

#include <optional>

#include "common/math.h"

namespace prosector {

class FollowedEye {
 public:
  /// Takes where the eye was seen, in seconds of a clock that doesn't fall.
  void saw(const Vec3& eye, double seconds);
  /// Returns where it is taken to be; `rest` is where it is while it isn't seen. Once it has been seen for a
  /// while that is exactly where it was seen last.
  Vec3 at(double seconds, const Vec3& rest);

  static constexpr double held = 0.5;            // s that it stays where it was seen last
  static constexpr double away = 1, back = 0.4;  // s that the ways to its resting place and back take

 private:
  Vec3 seen_ = Vec3::Zero(), from_ = Vec3::Zero(), shown_ = Vec3::Zero();
  std::optional<double> seen_at_, turned_at_;  // s: when it was seen last, and when last lost or found
  bool is_seen_ = false;
};

}  // namespace prosector
