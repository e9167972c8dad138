#pragma once
// Statistics of a headset's frame timing.

#include <cstdint>

namespace prosector {

class FramePacing {
 public:
  /// Adds a frame: end of its wait, predicted display time (each in its own clock), and the display period
  /// reported by the runtime. All in ns.
  void take(std::int64_t begun_ns, std::int64_t seen_ns, std::int64_t period_ns);
  /// Makes the next frame the first of a new sequence, after an interruption.
  void pause() { follows_ = false; }

  std::uint64_t frames() const { return frames_; }
  /// Returns the number of display periods without a frame.
  std::uint64_t missed() const { return missed_; }
  /// Returns the number of frames whose interval from the previous one deviated from the period by less than
  /// a quarter of it.
  std::uint64_t in_time() const { return in_time_; }
  /// Returns the last reported period, ms; 0: none.
  double period_ms() const { return 1e-6 * static_cast<double>(period_ns_); }
  /// Returns the mean interval between frames, ms; 0: no interval yet.
  double interval_ms() const;
  /// Returns the longest interval between frames, ms.
  double longest_ms() const { return 1e-6 * static_cast<double>(longest_ns_); }

 private:
  bool follows_ = false;
  std::uint64_t frames_ = 0, missed_ = 0, in_time_ = 0, intervals_ = 0;
  std::int64_t begun_ns_ = 0, seen_ns_ = 0, period_ns_ = 0, sum_ns_ = 0, longest_ns_ = 0;
};

}  // namespace prosector
