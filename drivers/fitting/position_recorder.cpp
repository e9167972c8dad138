#include "drivers/fitting/position_recorder.h"

namespace prosector {

std::optional<Pose> PositionRecorder::take(std::int64_t time_ns, const Pose& pose) {
  if (!last_) last_ = pose.p;
  if (!left_ && (pose.p - *last_).norm() > leave_) {
    left_ = true;
    window_.clear();
  }
  window_.take(time_ns, pose);
  if (!left_ || !window_.still()) return std::nullopt;
  const Pose mean = window_.mean();
  // A hand that slows down just after leaving is still near the last position.
  if ((mean.p - *last_).norm() < leave_) return std::nullopt;
  last_ = mean.p;
  left_ = false;
  return mean;
}

}  // namespace prosector
