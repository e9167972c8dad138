#pragma once
// Passes the host's requests for accuracy to the remodeller, and the results to the participants that made
// the requests.

#include <functional>
#include <string>
#include <vector>

#include "server/physics/simulation.h"
#include "server/session/people/session.h"
#include "server/session/run/body_reports.h"
#include "server/session/run/remodeller.h"

namespace prosector {

class RemodelRequests {
 public:
  /// Stores references: the simulation and the remodeller must outlive the object. `remodeller` may be null:
  /// models of bodies can't be changed. `say` is called with the lines of the session's log.
  RemodelRequests(const Simulation& simulation, Remodeller* remodeller,
                  std::function<void(const std::string&)> say);

  /// Passes the host's requests for bodies' accuracy to the remodeller, which changes bodies' models. Sends
  /// the results of earlier requests to the participants that made them, once those participants have joined.
  void pass_on(Session& session, BodyReports& bodies);
  /// Sets the errors and costs that are available for bodies, so that the host learns them.
  void set_prices(BodyReports& bodies) const;

 private:
  const Simulation& simulation_;
  Remodeller* remodeller_;
  std::function<void(const std::string&)> say_;
  std::vector<AccuracyAnswer> unheard_;  // for participants that are not in the session
};

}  // namespace prosector
