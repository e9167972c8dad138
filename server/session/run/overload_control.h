#pragma once
// Solves bodies less exactly while the server of a live session is overloaded. Also combines this with the
// host's own settings.

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "server/physics/simulation.h"
#include "server/session/run/effort_dial.h"
#include "server/session/run/governor.h"

namespace prosector {

class OverloadControl {
 public:
  /// Controls the bodies whose scene allows stepping down. `say` is called with the lines of the session's
  /// log. The simulation must outlive the object.
  OverloadControl(const Simulation& simulation, std::function<void(const std::string&)> say);

  /// Completes the changes of solver effort that are inputs of the next tick. `efforts` contains those of the
  /// host. They are replaced by those that apply, and the change that judge() decided is appended.
  void apply(std::vector<EffortChange>& efforts);
  /// Makes the duration of a tick an input of the next: decides whether a body is solved less or more
  /// exactly. `report` is that of the tick, which took `seconds` of wall time.
  void judge(const StepReport& report, double seconds);
  /// Returns the bodies that are solved less exactly, as text for the server's status.
  std::string stepped_down() const;

 private:
  const Simulation& simulation_;
  std::function<void(const std::string&)> say_;
  Governor governor_;
  EffortDial dial_;
  std::optional<EffortChange> next_;  // for the next tick

  std::map<BodyId, double> work_in(const StepReport& report) const;
  void announce(const EffortChange& change) const;
};

}  // namespace prosector
