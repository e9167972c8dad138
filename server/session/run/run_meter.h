#pragma once
// Measures a run of a live session: durations of its ticks, participants, and how fast simulated time passes.

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "server/physics/simulation.h"
#include "server/session/people/command_count.h"
#include "server/session/people/roster.h"
#include "server/session/run/step_meter.h"

namespace prosector {

struct RunFigures {
  std::uint64_t ticks = 0, late_ticks = 0, slips = 0;
  std::uint32_t participants = 0, observers = 0;      // most at a time; observers separately
  double real_time_factor = 0;                        // over the whole run
  double real_time_factor_with_participants = 0;      // since the first member joined; 0: none did
  std::map<std::string, double> max_displacement_mm;  // by soft body: maximum over the run
  std::uint64_t invalid_dropped = 0, hand_timeouts = 0;
  std::uint64_t refused_checkpoints = 0;  // checkpoints of this run that can't be restored
  CommandCounts commands{};
  std::uint64_t state_hash = 0;  // of the last tick
};

class RunMeter {
 public:
  explicit RunMeter(double tick_rate) : tick_rate_(tick_rate), steps_(tick_rate) {}

  /// Adds the tick that the simulation has just run, from `begun_ns` to `ended_ns` (nanoseconds on a
  /// monotonic clock).
  void add(const Simulation& simulation, const Roster& roster, const StepReport& report,
           std::int64_t begun_ns, std::int64_t ended_ns);
  /// Records that messages are processed without a tick at the time `now_ns` (nanoseconds on a monotonic
  /// clock), because simulated time is stopped.
  void pass(std::int64_t now_ns) { last_end_ns_ = now_ns; }
  /// Sets how often a tick was too late to be caught up.
  void set_slips(std::uint64_t slips) { figures_.slips = slips; }

  /// Returns the time (nanoseconds on a monotonic clock) at which the last tick ended, or at which messages
  /// were last processed without a tick.
  std::int64_t last_end_ns() const { return last_end_ns_; }
  /// Returns the time of last_end_ns() in seconds.
  double last_end() const { return 1e-9 * static_cast<double>(last_end_ns_); }
  const StepMeter& steps() const { return steps_; }
  /// Returns the measured figures of the run. Those of the session, the network and the journal, and the
  /// state's hash, are not set.
  RunFigures figures() const;

 private:
  struct Count {  // tick and wall time of an event
    std::uint64_t tick;
    std::int64_t ns;
  };
  double tick_rate_;
  StepMeter steps_;
  std::uint64_t last_tick_ = 0;
  std::int64_t last_end_ns_ = 0;
  std::optional<Count> start_, first_arrival_;
  RunFigures figures_;

  double real_time_factor(const std::optional<Count>& since) const;
};

}  // namespace prosector
