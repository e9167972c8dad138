#pragma once
// Whether what is measured is held still, and its mean while it is.

#include <cstdint>
#include <deque>

#include "common/math.h"
#include "drivers/fitting/pose_errors.h"

namespace prosector {

struct StillLimits {
  double seconds = 0.5;    // for so long it must be still
  double motion = 1e-3;    // m: between the means of both halves; noise of a reading is not motion
  double turn = 0.01;      // rad, between those of orientations
  std::size_t least = 20;  // readings, which a camera takes longer for
};

/// The newest readings of a pose, over the limits' time, or longer until they are enough. Noise averages out
/// of the means of its two halves, motion does not.
class StillWindow {
 public:
  explicit StillWindow(const StillLimits& limits = {}) : limits_(limits) {}
  void take(std::int64_t time_ns, const Pose& pose);
  void clear() { readings_.clear(); }
  bool still() const { return still_; }
  /// Returns how far the window is filled, 0 to 1.
  double filled() const;
  /// Returns the mean pose of the window; positions by their mean, orientations by that of quaternions.
  Pose mean() const;
  /// Returns how far off the mean is to be expected, by what its halves differ.
  const PoseErrors& mean_error() const { return mean_error_; }

 private:
  struct Reading {
    std::int64_t time_ns;
    Pose pose;
  };
  Pose mean_of(std::size_t first, std::size_t end) const;

  StillLimits limits_;
  std::deque<Reading> readings_;
  PoseErrors mean_error_;
  bool still_ = false;
};

}  // namespace prosector
