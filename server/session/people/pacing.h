#pragma once
// Pace of simulated time, which the host sets: a share of real time, tick by tick, or stopped.

#include <cstdint>

#include "common/commands.h"
#include "common/refusal.h"

namespace prosector {

class Pacing {
 public:
  /// Sets the largest pace that may be requested, simulated seconds per real second.
  explicit Pacing(double most = 1) : most_(most) {}

  /// Sets the pace. Refuses values out of bounds.
  Refusal obey(const SetPace& command);
  /// Stops time after the requested ticks. Refuses numbers out of bounds.
  Refusal obey(const StepTicks& command);
  /// Runs the next tick even if time is stopped.
  void run_one_tick() { steps_ += stands() ? 1 : 0; }

  /// Sets the pace from now on, whatever the host set before; 0: stopped.
  void set(double pace) { pace_ = pace, steps_ = 0; }

  /// Returns simulated seconds per real second.
  double pace() const { return pace_; }
  /// Returns whether time is stopped and the host has requested no tick.
  bool stands() const { return pace_ == 0 && steps_ == 0; }
  /// Counts a tick that was run.
  void finish_tick() { steps_ -= pace_ == 0 && steps_ > 0 ? 1 : 0; }

 private:
  double most_, pace_ = 1;
  std::uint32_t steps_ = 0;  // ticks still to run while time is stopped
};

}  // namespace prosector
