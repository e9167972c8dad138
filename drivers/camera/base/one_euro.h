#pragma once
// The 1€ filter (Casiez, Roussel and Vogel 2012): strong smoothing at rest, little lag in motion.
//
// It is a first-order low-pass whose cut-off frequency grows with speed: f = least + beta·|v|. The lag at
// speed v is about 1/(2π f). With the defaults it is 160 ms near zero speed and 7 ms at 0.4 m/s.

#include <optional>

#include "common/math.h"

namespace prosector {

struct OneEuroSettings {
  double least = 1;      // Hz, cut-off frequency at rest
  double beta = 50;      // Hz per m/s
  double turn_beta = 5;  // Hz per rad/s
  double speed_cut = 1;  // Hz, cut-off frequency of the speed's low-pass
  double forgets = 0.5;  // s without a pose, after which the filter resets
};

/// Filter that smooths poses with time stamps: strongly at rest, with little lag in motion (1€ filter).
class PoseFilter {
 public:
  explicit PoseFilter(const OneEuroSettings& settings = {}) : settings_(settings) {}

  /// Processes the pose measured at `time_ns` and returns the smoothed pose. Times must increase; a time that
  /// does not, or a long gap, resets the filter to the measured pose.
  Pose update(const Pose& pose, std::int64_t time_ns);

 private:
  struct State {
    Pose pose;
    Vec3 speed = Vec3::Zero(), turning = Vec3::Zero();  // m/s, rad/s
    std::int64_t time_ns = 0;
  };
  OneEuroSettings settings_;
  std::optional<State> state_;
};

}  // namespace prosector
