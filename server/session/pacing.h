#pragma once
// How simulated time goes by, as the host has it: at a share of real time, tick by tick, or not at all.

#include <cstdint>

#include "common/messages.h"
#include "common/refusal.h"

namespace prosector {

class Pacing {
 public:
  /// Takes the most that may be asked for, simulated seconds a real one.
  explicit Pacing(double most = 1) : most_(most) {}

  /// Obeys set_pace and step_ticks. Refuses other than the host, and what is out of bounds.
  Refusal obey(const Command& command, Role role);
  /// Lets the next tick run though time stands still.
  void run_one_tick() { steps_ += stands() ? 1 : 0; }

  /// Lets time run at this pace from now on, 0: not at all, whoever had it otherwise.
  void set(double pace) { pace_ = pace, steps_ = 0; }

  /// Returns simulated seconds a real one.
  double pace() const { return pace_; }
  /// Tells whether no tick is due until the host asks for one.
  bool stands() const { return pace_ == 0 && steps_ == 0; }
  /// Takes that a tick was run.
  void finish_tick() { steps_ -= pace_ == 0 && steps_ > 0 ? 1 : 0; }

 private:
  double most_, pace_ = 1;
  std::uint32_t steps_ = 0;  // ticks still to run while time stands still
};

}  // namespace prosector
