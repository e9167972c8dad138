#pragma once
// Reports on bodies that are sent to clients: which participants changed and hold them (PartState), and how
// they are stepped (BodyStatus).

#include <map>
#include <string>
#include <vector>

#include "server/session/run/body_meter.h"
#include "server/session/sending/part_sender.h"

namespace prosector {

class BodyReports {
 public:
  /// Starts with the simulation's present bodies. `expected` has the expected error and cost, by body name,
  /// of the soft bodies whose model was chosen for a required accuracy or budget. The simulation must outlive
  /// the object.
  BodyReports(const Simulation& simulation, std::map<std::string, Prospect> expected);

  /// Adds the pieces that cuts have created since the last call.
  void add_pieces();
  /// Adds a tick's report to the status of soft bodies.
  void add(const StepReport& report) { meter_.add(simulation_, report); }
  /// Returns the messages that are due after the last tick: part states, then statuses.
  std::vector<Outgoing> take();
  /// Sets the pairs of error and cost from which the host can choose for a body.
  void set_prices(BodyId body, std::vector<Price> prices) { meter_.set_prices(body, std::move(prices)); }
  /// Starts to measure again, with the bodies of the present state, after a jump in a recording.
  void restart();

  const BodyMeter& meter() const { return meter_; }

 private:
  const Simulation& simulation_;
  std::map<std::string, Prospect> expected_;
  BodyMeter meter_;
  std::size_t metered_;  // number of bodies in meter_
  PartSender parts_;
};

}  // namespace prosector
