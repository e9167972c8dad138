#pragma once
// Schedules the start of ticks. It gets all times as arguments, so that tests need no clock.

#include <cstdint>

#include "common/assert.h"

namespace prosector {

/// Schedule of ticks at a fixed rate at which lag does not accumulate. The following ticks catch up a late
/// tick while the lag is at most one period. Beyond that the schedule slips, which slows simulated time.
class TickSchedule {
 public:
  TickSchedule(double tick_rate, std::int64_t start_ns)
      : period_at_full_pace_ns_(1e9 / tick_rate),
        period_ns_(static_cast<std::int64_t>(period_at_full_pace_ns_)),
        due_ns_(start_ns) {}

  /// Sets the pace (simulated seconds per real second), from the tick after the next on.
  void set_pace(double pace) {
    PROSECTOR_ASSERT(pace > 0);
    period_ns_ = static_cast<std::int64_t>(period_at_full_pace_ns_ / pace);
  }

  /// Returns the time (ns, monotonic clock) at which the current tick should start.
  std::int64_t due_ns() const { return due_ns_; }
  /// Records that the current tick ended at `now_ns`, and schedules the next one.
  void finished(std::int64_t now_ns) {
    due_ns_ += period_ns_;
    const std::int64_t slip = now_ns - due_ns_ - period_ns_;
    if (slip <= 0) return;
    due_ns_ += slip;
    slipped_ns_ += slip;
    ++slips_;
  }
  std::uint64_t slips() const { return slips_; }
  std::int64_t slipped_ns() const { return slipped_ns_; }

 private:
  double period_at_full_pace_ns_;
  std::int64_t period_ns_, due_ns_, slipped_ns_ = 0;
  std::uint64_t slips_ = 0;
};

}  // namespace prosector
