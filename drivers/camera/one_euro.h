#pragma once
// The 1€ filter (Casiez, Roussel and Vogel 2012): what rests is smoothed much, what moves follows at once.
//
// A first-order low-pass whose cut-off frequency grows with speed: f = least + beta·|v|. Its lag at speed v
// is about 1/(2π f): with the defaults 160 ms of a drift of nearly nothing, 7 ms at 0.4 m/s.

#include <optional>

#include "common/math.h"

namespace prosector {

struct OneEuroSettings {
  double least = 1;      // Hz, of what rests
  double beta = 50;      // Hz for each m/s
  double turn_beta = 5;  // Hz for each rad/s
  double speed_cut = 1;  // Hz, of the low-pass of the speed itself
  double forgets = 0.5;  // s without a pose, after which it begins anew
};

/// Smooths poses that come with their times.
class PoseFilter {
 public:
  explicit PoseFilter(const OneEuroSettings& settings = {}) : settings_(settings) {}

  /// Returns the pose smoothed. Times must not fall; one that does begins anew.
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
