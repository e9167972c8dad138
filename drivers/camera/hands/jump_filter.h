#pragma once
// Rejects poses of a hand that jump. A corrupted image sometimes flips a hand over, faster than a hand can
// move.

#include <cstdint>
#include <optional>

#include "common/math.h"

namespace prosector {

/// Outlier filter for one hand's poses. A jump is accepted after two more images confirm it.
class JumpFilter {
 public:
  /// Processes the next pose, of the palm's centre. Returns whether to accept it.
  bool accepts_pose(const Pose& palm, std::int64_t time_ns);
  /// Forgets the hand; its next pose is accepted.
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
