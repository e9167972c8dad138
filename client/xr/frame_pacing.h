#pragma once
// Statistics of a headset's frame timing.

#include <cstdint>

namespace prosector {

class FramePacing {
 public:
  /// Adds a frame to the statistics. `begun_ns` is when the wait for the frame ended, `seen_ns` its predicted
  /// display time (each in its own clock), and `period_ns` the display period that the runtime reported. All
  /// in ns.
  void take(std::int64_t begun_ns, std::int64_t seen_ns, std::int64_t period_ns);
  /// Notes an interruption: the interval between the previous and the next frame is not counted.
  void pause() { follows_ = false; }

  std::uint64_t frames() const { return frames_; }
  /// Returns the number of display periods for which no frame was rendered.
  std::uint64_t missed() const { return missed_; }
  /// Returns the number of frames whose interval from the previous frame deviated from the display period by
  /// less than a quarter of the period.
  std::uint64_t in_time() const { return in_time_; }
  /// Returns the display period that the runtime last reported, ms; 0 if there was no frame.
  double period_ms() const { return 1e-6 * static_cast<double>(period_ns_); }
  /// Returns the mean interval between successive frames, ms; 0 before the second frame.
  double interval_ms() const;
  /// Returns the longest interval between successive frames, ms; 0 before the second frame.
  double longest_ms() const { return 1e-6 * static_cast<double>(longest_ns_); }

 private:
  bool follows_ = false;
  std::uint64_t frames_ = 0, missed_ = 0, in_time_ = 0, intervals_ = 0;
  std::int64_t begun_ns_ = 0, seen_ns_ = 0, period_ns_ = 0, sum_ns_ = 0, longest_ns_ = 0;
};

}  // namespace prosector
