#pragma once
// Collects how each deformable is stepped and how accurate it is, for BodyStatus: tick by tick, reported
// twice a simulated second.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "common/error_estimate.h"
#include "common/ids.h"
#include "common/status_messages.h"
#include "server/accuracy/live_estimates.h"
#include "server/calibration/choose_rung.h"
#include "server/calibration/rung_table.h"
#include "server/physics/simulation.h"

namespace prosector {

/// Returns the expected error and cost, by body name, of the bodies whose model was chosen for a required
/// accuracy or budget.
std::map<std::string, Prospect> expectations_of(const std::vector<Choice>& choices);

/// A press of hands on a soft body: its force, and the estimated relative error of that force.
struct MeteredPress {
  double force = 0;   // N
  double error = -1;  // relative
};

class BodyMeter {
 public:
  /// Starts with the scene's soft bodies. `expected` has the expected error and cost, by body name, of those
  /// whose model was chosen for a required accuracy or budget.
  BodyMeter(const Simulation& simulation, const std::map<std::string, Prospect>& expected);

  /// Adds a soft body, for instance one that a cut created. `expected` is its expected error and cost; null
  /// if its model was not chosen for a required accuracy or budget.
  void add_body(const Simulation& simulation, BodyId body, const Prospect* expected = nullptr);
  /// Sets the pairs of error and cost from which the host can choose for a body. They are sent with its next
  /// status.
  void set_prices(BodyId body, std::vector<Price> prices);
  /// Adds a tick's solver statistics to those of each soft body, and continues the error estimates.
  void add(const Simulation& simulation, const StepReport& report);
  /// Returns the status messages of soft bodies that are due after the last tick; in the first call, those of
  /// all bodies. A body that falls asleep is reported immediately. Other bodies are reported at 2 Hz if they
  /// were awake since their last report, or have a new error estimate.
  std::vector<BodyStatus> take(const Simulation& simulation);
  /// Returns the newest status of each soft body that take() has returned.
  const std::map<BodyId, BodyStatus>& newest() const { return newest_; }
  /// Returns the largest estimated relative error of any soft body. Below 0 if no error is known.
  double worst_error() const;
  /// Returns, by soft body, the strongest press by hands for which the error of the force is known.
  const std::map<BodyId, MeteredPress>& presses() const { return presses_; }

 private:
  struct Sum {
    BodyStatus status;  // of the ticks since the last report
    std::uint32_t ticks = 0;
    double newton_iterations = 0, solver_iterations = 0;
    bool was_asleep = false;
    bool reported = false;
    std::uint64_t reported_estimate = 0;  // tick of the estimate that was reported last
  };
  double tick_seconds_;
  std::uint64_t period_;  // ticks
  std::map<std::string, BodyId> id_of_;
  std::map<BodyId, Sum> sums_;
  std::map<BodyId, BodyStatus> newest_;
  std::map<BodyId, MeteredPress> presses_;
  LiveEstimates estimates_;

  bool news_of_rest(BodyId body, const Sum& sum) const;
  BodyStatus close(Sum& sum, const Simulation& simulation) const;
};

}  // namespace prosector
