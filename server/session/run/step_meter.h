#pragma once
// Measures the cost of steps: over the last second, for the status; over the whole run, for the summary.

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "server/physics/base/step_report.h"

namespace prosector {

/// Histogram of positive durations in constant memory, from which quantiles are read to within 1 %. Its bins
/// are logarithmic.
class DurationHistogram {
 public:
  void add(double ms);
  /// Returns the quantile `q` (0 to 1) of the added durations, ms; 0 if there are none.
  double quantile(double q) const;
  std::uint64_t count() const { return count_; }

 private:
  static constexpr std::size_t bins = 1700;
  std::array<std::uint64_t, bins> bin_{};
  std::uint64_t count_ = 0;
};

struct LastSecond {
  double real_time_factor = 0;
  double step_ms_p50 = 0, step_ms_p99 = 0;
  std::array<double, step_phases> phase_ms{};  // mean
  double solver_residual = 0;                  // worst
  std::string degraded;                        // bodies and what is wrong with them; empty: nothing
};

/// Energy of all bodies, and numbers of awake and sleeping bodies, after the last step.
struct LastStep {
  double energy = 0;                    // J: kinetic, elastic and gravitational
  std::uint32_t awake = 0, asleep = 0;  // bodies
};

class StepMeter {
 public:
  explicit StepMeter(double tick_rate) : dt_(1 / tick_rate) {}

  /// Adds a tick's durations and report. `begun_ns` and `ended_ns` are the start and end of the whole tick,
  /// including the processing of messages and the snapshot, on the monotonic clock. `tissue_awake`: whether
  /// any soft body was awake.
  void add(const StepReport& report, bool tissue_awake, std::int64_t begun_ns, std::int64_t ended_ns);
  LastSecond last_second() const;
  const LastStep& last_step() const { return last_step_; }

  const DurationHistogram& all() const { return all_; }
  const DurationHistogram& awake() const { return awake_; }  // ticks with tissue awake
  std::uint64_t late() const { return late_; }               // ticks longer than their period
  /// Returns, by body name, the number of ticks of the run in which the body was reset or its solver did not
  /// converge.
  const std::map<std::string, std::uint64_t>& troubles() const { return troubles_; }

 private:
  struct Tick {
    std::int64_t ended_ns;
    double ms;
    std::array<double, step_phases> phase_ms;
    double residual;
    std::vector<std::string> degraded;
  };
  double dt_;
  LastStep last_step_;
  std::deque<Tick> ticks_;  // the last second
  DurationHistogram all_, awake_;
  std::uint64_t late_ = 0;
  std::map<std::string, std::uint64_t> troubles_;
};

}  // namespace prosector
