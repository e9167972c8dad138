#pragma once
// The rhythm in which a headset's runtime wants pictures, and how well it was kept.

#include <cstdint>

namespace prosector {

class FramePacing {
 public:
  /// Takes a frame: when its wait was over, when it is seen, each of a clock of its own; and the period that
  /// the runtime tells. All in ns.
  void take(std::int64_t begun_ns, std::int64_t seen_ns, std::int64_t period_ns);
  /// Lets the next frame follow none: there was no rhythm meanwhile.
  void pause() { follows_ = false; }

  std::uint64_t frames() const { return frames_; }
  /// Returns how many times of the runtime's went by without a frame.
  std::uint64_t missed() const { return missed_; }
  /// Returns how many frames began a period after the one before, but for a quarter of it.
  std::uint64_t in_time() const { return in_time_; }
  /// Returns the period as last told, ms; 0: not told.
  double period_ms() const { return 1e-6 * static_cast<double>(period_ns_); }
  /// Returns the mean time from frame to frame, ms; 0: none followed another.
  double interval_ms() const;
  /// Returns the longest time from frame to frame, ms.
  double longest_ms() const { return 1e-6 * static_cast<double>(longest_ns_); }

 private:
  bool follows_ = false;
  std::uint64_t frames_ = 0, missed_ = 0, in_time_ = 0, intervals_ = 0;
  std::int64_t begun_ns_ = 0, seen_ns_ = 0, period_ns_ = 0, sum_ns_ = 0, longest_ns_ = 0;
};

}  // namespace prosector
