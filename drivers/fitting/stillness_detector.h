#pragma once
// Detects whether a receiver is held still, and averages its pose.

#include <cstdint>
#include <deque>

#include "common/math.h"
#include "drivers/fitting/pose_errors.h"

namespace prosector {

struct StillnessLimits {
  double seconds = 0.5;    // s, least time at rest
  double motion = 1e-3;    // m: between the means of both halves; reading noise isn't motion
  double turn = 0.01;      // rad, between the mean orientations of both halves
  std::size_t least = 20;  // readings; a camera needs longer to collect them
};

/// Detector of a receiver that is held still. It stores the newest poses, as many as the limits' time and
/// count require, and compares the means of their older and newer half. Noise averages out in these means;
/// motion does not.
class StillnessDetector {
 public:
  explicit StillnessDetector(const StillnessLimits& limits = {}) : limits_(limits) {}
  void take(std::int64_t time_ns, const Pose& pose);
  void clear() { readings_.clear(); }
  bool still() const { return still_; }
  /// Returns the fraction (0 to 1) of the required readings and time at rest that has been collected.
  double filled() const;
  /// Returns the mean of the collected poses: the arithmetic mean of positions and the quaternion mean of
  /// orientations.
  Pose mean() const;
  /// Returns the expected error of mean(), m and rad: half the difference between the mean poses of the older
  /// and of the newer half of the readings.
  const PoseErrors& mean_error() const { return mean_error_; }

 private:
  struct Reading {
    std::int64_t time_ns;
    Pose pose;
  };
  Pose mean_of(std::size_t first, std::size_t end) const;

  StillnessLimits limits_;
  std::deque<Reading> readings_;
  PoseErrors mean_error_;
  bool still_ = false;
};

}  // namespace prosector
