#pragma once
// Time-stamped samples of a moving object, with interpolation.

#include <algorithm>
#include <cstdint>
#include <deque>

#include "common/assert.h"
#include "common/math.h"

namespace prosector {

/// Returns the cubic Hermite interpolation between position x0 with velocity v0 and x1 with v1, `h` seconds
/// apart, at fraction s in [0, 1]. Linear interpolation would have an error of a·h²/8 under acceleration a.
inline Vec3 hermite(const Vec3& x0, const Vec3& v0, const Vec3& x1, const Vec3& v1, double h, double s) {
  const double s2 = s * s, s3 = s2 * s;
  return (2 * s3 - 3 * s2 + 1) * x0 + (s3 - 2 * s2 + s) * h * v0 + (3 * s2 - 2 * s3) * x1 +
         (s3 - s2) * h * v1;
}

/// Last 16 samples of one moving object, such as a body or user, in order of time. Late samples are inserted
/// in order; samples from before a rewind (of earlier epochs) are dropped.
template <class Sample>
class Track {
 public:
  void add(Sample sample) {
    if (!samples_.empty() && sample.time.epoch < samples_.back().time.epoch) return;
    if (!samples_.empty() && sample.time.epoch > samples_.back().time.epoch) samples_.clear();
    auto at = std::upper_bound(samples_.begin(), samples_.end(), sample.time.tick,
                               [](std::uint64_t tick, const Sample& s) { return tick < s.time.tick; });
    if (at != samples_.begin() && std::prev(at)->time.tick == sample.time.tick)
      *std::prev(at) = std::move(sample);
    else
      samples_.insert(at, std::move(sample));
    while (samples_.size() > capacity) samples_.pop_front();
  }

  struct Bracket {
    const Sample* from = nullptr;
    const Sample* to = nullptr;  // equal to `from`: constant
    double seconds = 0;          // time between them, limited to the bridged gap
    double share = 0;            // 0 at `from`, 1 at `to`
  };

  /// Returns the samples between which to interpolate at `tick`, and the fraction. `dt`: duration of a tick,
  /// s. In a gap longer than `bridge` ticks the object was at rest, so `from` is held until `bridge` ticks
  /// before `to`.
  Bracket at(double tick, double dt, double bridge = 4) const {
    PROSECTOR_ASSERT(bridge > 0);
    Bracket out;
    if (samples_.empty()) return out;
    auto to = std::find_if(samples_.begin(), samples_.end(),
                           [&](const Sample& s) { return static_cast<double>(s.time.tick) > tick; });
    if (to == samples_.begin()) return {&*to, &*to, 0, 0};
    const Sample& from = *std::prev(to);
    if (to == samples_.end()) return {&from, &from, 0, 0};
    const double end = static_cast<double>(to->time.tick);
    const double gap = std::min(end - static_cast<double>(from.time.tick), bridge);
    if (tick <= end - gap) return {&from, &from, 0, 0};
    return {&from, &*to, gap * dt, (tick - (end - gap)) / gap};
  }

  /// Calls `change(sample)` for each stored sample, to modify it; its time must stay unchanged.
  template <class Change>
  void change_each(const Change& change) {
    for (Sample& sample : samples_) change(sample);
  }

  bool empty() const { return samples_.empty(); }
  const Sample& newest() const { return samples_.back(); }

 private:
  static constexpr std::size_t capacity =
      16;  // a quarter of a second at 60 Hz, more than usual playout delays
  std::deque<Sample> samples_;
};

}  // namespace prosector
