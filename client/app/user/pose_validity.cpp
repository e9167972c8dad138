#include "client/app/user/pose_validity.h"

#include <algorithm>

namespace prosector {
namespace {

constexpr std::int64_t min_validity_ns = 250'000'000, max_validity_ns = 1'000'000'000;
constexpr std::int64_t validity_intervals = 2;  // intervals after which the next pose counts as missing

}  // namespace

void PoseValidity::see(std::int64_t time_ns, std::int64_t now_ns) {
  if (time_ns <= seen_ns_) return;  // from another camera, or a duplicate
  gap_before_ns_ = last_gap_ns_;
  last_gap_ns_ = seen_ns_ == 0 ? 0 : time_ns - seen_ns_;
  seen_ns_ = time_ns;
  delay_ns_ = now_ns - time_ns;
}

/// Returns the validity time: the last delay plus two intervals, clamped to 0.25 … 1 s. The shorter of the
/// last two intervals is used, because a single long one is due to a loss.
std::int64_t PoseValidity::validity_ns() const {
  const std::int64_t gap = std::min(last_gap_ns_, gap_before_ns_);
  return std::clamp(delay_ns_ + validity_intervals * gap, min_validity_ns, max_validity_ns);
}

}  // namespace prosector
