#include "client/xr/frame_pacing.h"

#include <algorithm>
#include <cstdlib>

namespace prosector {

void FramePacing::take(std::int64_t begun_ns, std::int64_t seen_ns, std::int64_t period_ns) {
  ++frames_;
  period_ns_ = period_ns;
  if (follows_) {
    const std::int64_t interval = begun_ns - begun_ns_;
    ++intervals_;
    sum_ns_ += interval;
    longest_ns_ = std::max(longest_ns_, interval);
    if (4 * std::abs(interval - period_ns) < period_ns) ++in_time_;
    // Rounded: predicted times vary slightly.
    const std::int64_t periods = period_ns > 0 ? (seen_ns - seen_ns_ + period_ns / 2) / period_ns : 1;
    if (periods > 1) missed_ += static_cast<std::uint64_t>(periods - 1);
  }
  begun_ns_ = begun_ns;
  seen_ns_ = seen_ns;
  follows_ = true;
}

double FramePacing::interval_ms() const {
  return intervals_ > 0 ? 1e-6 * static_cast<double>(sum_ns_) / static_cast<double>(intervals_) : 0;
}

}  // namespace prosector
