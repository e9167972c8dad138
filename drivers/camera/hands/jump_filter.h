#pragma once
// Rejects poses of a hand that jump. A corrupted image sometimes flips a hand over, faster than a hand can
// move.

#include <cstdint>
#include <optional>

#include "common/math.h"

namespace prosector {

/// Outlier filter for the poses of one tracked hand. It rejects a pose that jumps from the last accepted one,
/// until two more images confirm the new pose.
class JumpFilter {
 public:
  /// Processes the palm's pose in the image captured at `time_ns`. Returns whether to accept it; false if it
  /// is an unconfirmed jump.
  bool accepts_pose(const Pose& palm, std::int64_t time_ns);
  /// Forgets the hand's last accepted pose, so that its next pose is accepted.
  void forget() { believed_.reset(); }

 private:
  struct Seen {
    Pose palm;
    std::int64_t time_ns = 0;
  };
  static bool leaps(const Seen& from, const Seen& to);

  std::optional<Seen> believed_, leapt_;
  int seen_again_ = 0;  // number of images that confirmed the jump after its first
};

}  // namespace prosector
