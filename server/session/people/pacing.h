#pragma once
// Pace of simulated time, which the host sets: a share of real time, tick by tick, or stopped.

#include <cstdint>

#include "common/commands.h"
#include "common/refusal.h"

namespace prosector {

class Pacing {
 public:
  /// Starts at real-time pace. `most` is the largest pace that may be requested, in simulated seconds per
  /// real second.
  explicit Pacing(double most = 1) : most_(most) {}

  /// Sets the pace that the host requested, in simulated seconds per real second; 0 stops time. Returns the
  /// reason if the value is out of bounds.
  Refusal obey(const SetPace& command);
  /// Stops simulated time after the number of further ticks that the host requested. Returns the reason if
  /// the number is out of bounds.
  Refusal obey(const StepTicks& command);
  /// Makes the next tick run even if simulated time is stopped.
  void run_one_tick() { steps_ += is_stopped() ? 1 : 0; }

  /// Sets the pace, in simulated seconds per real second, and drops the host's requests for single
  /// ticks. 0 stops simulated time.
  void set(double pace) { pace_ = pace, steps_ = 0; }

  /// Returns the pace, in simulated seconds per real second. 0 means that simulated time is stopped, except
  /// for single ticks that the host requests.
  double pace() const { return pace_; }
  /// Returns whether simulated time is stopped and no further tick has been requested.
  bool is_stopped() const { return pace_ == 0 && steps_ == 0; }
  /// Counts a tick that was run: while time is stopped, reduces the number of requested ticks by one.
  void finish_tick() { steps_ -= pace_ == 0 && steps_ > 0 ? 1 : 0; }

 private:
  double most_, pace_ = 1;
  std::uint32_t steps_ = 0;  // ticks still to run while time is stopped
};

}  // namespace prosector
