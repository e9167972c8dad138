#pragma once
// A tracked eye position that eases to a resting position while tracking is lost.

#include <optional>

#include "common/math.h"

namespace prosector {

class EasedEyePosition {
 public:
  /// Records that the tracker detected the user's eye at the position `eye` at the time `seconds` (monotonic
  /// clock, s).
  void saw(const Vec3& eye, double seconds);
  /// Returns the eye position for rendering at the time `seconds` (monotonic clock, s). While the eye is
  /// tracked, it is the last detected position. After tracking is lost it moves smoothly to `rest`, and back
  /// once tracking resumes.
  Vec3 at(double seconds, const Vec3& rest);

  static constexpr double held = 0.5;  // s that the last detected position is held
  // s: durations of the motion to the resting position and back.
  static constexpr double away = 1, back = 0.4;

 private:
  Vec3 seen_ = Vec3::Zero(), from_ = Vec3::Zero(), shown_ = Vec3::Zero();
  // s: time of the last detection; time when tracking was last lost or regained.
  std::optional<double> seen_at_, turned_at_;
  bool is_seen_ = false;
};

}  // namespace prosector
