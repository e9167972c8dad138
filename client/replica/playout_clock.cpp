#include "client/replica/playout_clock.h"

#include <algorithm>
#include <cmath>

namespace prosector {
namespace {

constexpr std::int64_t window_ns = 1'000'000'000;
constexpr double max_delay = 0.25;  // s: worse jitter than this shows as stutter, not as lag
constexpr double snap_distance =
    0.5;  // s: farther off than this (start, rewind, long stall) the playhead jumps
constexpr double correction_rate = 0.15;  // the playhead runs at most this much faster or slower than time

}  // namespace

void PlayoutClock::arrived(const SimTime& time, std::int64_t arrival_ns) {
  if (time.epoch < epoch_) return;
  if (time.epoch > epoch_) {
    epoch_ = time.epoch;
    offsets_.clear();
    last_ns_ = 0;
  }
  const double offset = 1e-9 * static_cast<double>(arrival_ns) - static_cast<double>(time.tick) * dt_;
  offsets_.push_back({arrival_ns, offset});
  while (arrival_ns - offsets_.front().arrival_ns > window_ns) offsets_.pop_front();
}

double PlayoutClock::playhead(std::int64_t now_ns) {
  if (offsets_.empty()) return playhead_ / dt_;
  const auto [lowest, highest] = std::minmax_element(offsets_.begin(), offsets_.end(),
                                                     [](auto& a, auto& b) { return a.seconds < b.seconds; });
  delay_ = std::min(highest->seconds - lowest->seconds + dt_, max_delay);
  const double target = 1e-9 * static_cast<double>(now_ns) - lowest->seconds - delay_;
  if (last_ns_ == 0 || std::abs(target - playhead_) > snap_distance) {
    playhead_ = target;
  } else {
    const double passed = 1e-9 * static_cast<double>(now_ns - last_ns_);
    const double slack = correction_rate * passed;
    playhead_ += passed + std::clamp(target - (playhead_ + passed), -slack, slack);
  }
  last_ns_ = now_ns;
  playhead_ = std::max(playhead_, 0.0);
  return playhead_ / dt_;
}

}  // namespace prosector
