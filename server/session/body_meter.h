#pragma once
// How each deformable is stepped and how far it is off, for BodyStatus: gathered tick by tick, told twice a
// simulated second.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "common/messages.h"
#include "server/accuracy/live_estimates.h"
#include "server/calibration/choose_rung.h"
#include "server/calibration/rung_table.h"
#include "server/physics/simulation.h"

namespace prosector {

/// Returns what is expected of bodies that were chosen by need, by name.
std::map<std::string, Prospect> expectations_of(const std::vector<Choice>& choices);

/// A press by hands, and how far its force may be off.
struct MeteredPress {
  double force = 0;   // N
  double error = -1;  // fraction
};

class BodyMeter {
 public:
  /// Takes what is `expected`, by body name; bodies that are missing were not chosen by need.
  BodyMeter(const Simulation& simulation, const std::map<std::string, Prospect>& expected);

  /// Adds a soft body: one that a cut made, for instance. `expected`: null when it wasn't chosen by need.
  void add_body(const Simulation& simulation, BodyId body, const Prospect* expected = nullptr);
  /// Says what a body can have at what price; told with its next status.
  void set_prices(BodyId body, std::vector<Price> prices);
  /// Adds a tick, and goes on with the estimates.
  void add(const Simulation& simulation, const StepReport& report);
  /// Returns what is due after the tick that was added; at the first call of all. It tells of bodies that
  /// were awake since they were last told of. Of those that rest it tells once more when their error at rest
  /// is known.
  std::vector<BodyStatus> take(const Simulation& simulation);
  /// Returns the newest status of each body, told or not.
  const std::map<BodyId, BodyStatus>& newest() const { return newest_; }
  /// Returns the largest error that is known of a body now; below 0: none is.
  double worst_error() const;
  /// Returns the strongest press on each body whose error is known.
  const std::map<BodyId, MeteredPress>& presses() const { return presses_; }

 private:
  struct Sum {
    BodyStatus status;  // of the ticks since it was last told of
    std::uint32_t ticks = 0;
    double newton_iterations = 0, solver_iterations = 0;
    bool was_asleep = false;
    bool told = false;
    std::uint64_t told_estimate = 0;  // the tick of the estimate that was told
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
