#pragma once
// Where a step's time goes.

#include "common/clock.h"
#include "server/physics/base/step_report.h"

namespace prosector {

/// A stopwatch for a simulation step: adds the time since its last reading to a phase in the step's report.
/// It only measures; the simulation's results don't depend on it.
class PhaseClock {
 public:
  explicit PhaseClock(StepReport& report) : report_(report), start_(monotonic_ns()), last_(start_) {}
  void end(Phase phase) {
    const std::int64_t now = monotonic_ns();
    report_.seconds[static_cast<std::size_t>(phase)] += 1e-9 * static_cast<double>(now - last_);
    last_ = now;
    report_.total_seconds = 1e-9 * static_cast<double>(now - start_);
  }

 private:
  StepReport& report_;
  std::int64_t start_, last_;
};

}  // namespace prosector
