#include "client/view/eased_eye_position.h"

#include <algorithm>

namespace prosector {

void EasedEyePosition::saw(const Vec3& eye, double seconds) {
  seen_ = eye;
  seen_at_ = seconds;
}

Vec3 EasedEyePosition::at(double seconds, const Vec3& rest) {
  const bool is_seen = seen_at_ && seconds - *seen_at_ <= held;
  if (!turned_at_) shown_ = rest;
  if (is_seen != is_seen_ || !turned_at_) {
    from_ = shown_;
    turned_at_ = seconds;
  }
  is_seen_ = is_seen;
  const double share = std::clamp((seconds - *turned_at_) / (is_seen ? back : away), 0.0, 1.0);
  const double eased = share * share * (3 - 2 * share);
  const Vec3& target = is_seen ? seen_ : rest;
  shown_ = share < 1 ? Vec3(from_ + eased * (target - from_)) : target;
  return shown_;
}

}  // namespace prosector
