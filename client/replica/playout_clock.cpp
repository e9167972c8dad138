#include "client/replica/playout_clock.h"

#include <algorithm>
#include <cmath>

#include "common/assert.h"

namespace prosector {
namespace {

constexpr std::int64_t window_ns = 1'000'000'000;
constexpr double max_delay = 0.25;  // s: larger jitter causes stutter instead of delay
constexpr double snap_distance =
    0.5;  // s: for larger deviations (start, rewind, long stall) the playhead jumps
constexpr double correction_rate =
    0.15;                             // maximum relative speed difference between playhead and simulated time
constexpr double least_window = 0.3;  // s: shorter windows give no reliable slope
constexpr double slope_noise = 0.03;  // jitter alone can change the slope by this much

double seconds(std::int64_t ns) {
  return 1e-9 * static_cast<double>(ns);
}

}  // namespace

void PlayoutClock::arrived(const SimTime& time, std::int64_t arrival_ns) {
  if (time.epoch < epoch_) return;
  if (time.epoch > epoch_) {
    epoch_ = time.epoch;
    samples_.clear();
    last_ns_ = 0;
  }
  samples_.push_back({arrival_ns, static_cast<double>(time.tick) * dt_});
  while (arrival_ns - samples_.front().arrival_ns > window_ns) samples_.pop_front();
}

// Returns simulated seconds per real second.
double PlayoutClock::slope() const {
  PROSECTOR_ASSERT(!samples_.empty());
  const double window = seconds(samples_.back().arrival_ns - samples_.front().arrival_ns);
  if (window < least_window) return pace_;
  const double slope = std::clamp((samples_.back().simulated - samples_.front().simulated) / window, 0.0,
                                  std::max(1.0, pace_));
  return std::abs(slope - 1) < slope_noise ? 1 : slope;
}

double PlayoutClock::playhead(std::int64_t now_ns) {
  if (samples_.empty()) return playhead_ / dt_;
  const double slope = this->slope();
  const Sample& newest = samples_.back();
  const auto above_newest = [&](const Sample& s) {
    return s.simulated - newest.simulated - slope * seconds(s.arrival_ns - newest.arrival_ns);
  };
  double highest = 0, lowest = 0;
  for (const Sample& s : samples_) {
    highest = std::max(highest, above_newest(s));
    lowest = std::min(lowest, above_newest(s));
  }
  delay_ = std::min(highest - lowest + dt_, max_delay);
  const double target = newest.simulated + slope * seconds(now_ns - newest.arrival_ns) + highest - delay_;
  if (last_ns_ == 0 || std::abs(target - playhead_) > snap_distance) {
    playhead_ = target;
  } else {
    const double passed = slope * seconds(now_ns - last_ns_);
    const double slack = correction_rate * seconds(now_ns - last_ns_);
    playhead_ += std::max(0.0, passed + std::clamp(target - (playhead_ + passed), -slack, slack));
  }
  last_ns_ = now_ns;
  playhead_ = std::max(playhead_, 0.0);
  return playhead_ / dt_;
}

}  // namespace prosector
