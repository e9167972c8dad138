#include "server/session/run/overload_control.h"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "common/commands.h"
#include "server/physics/mechanics/soft/soft_body.h"

namespace prosector {
namespace {

/// Returns the bodies whose scene allows stepping down, with their steps in a restored state.
std::map<BodyId, int> may_step_down(const Simulation& simulation) {
  std::map<BodyId, int> out;
  for (BodyId b = 0; b < simulation.body_count(); ++b)
    if (simulation.kind(b) == BodyKind::soft && simulation.soft(b).desc().choice.step_down)
      out[b] = simulation.soft_state(b).steps_down;
  return out;
}

}  // namespace

OverloadControl::OverloadControl(const Simulation& simulation, std::function<void(const std::string&)> say)
    : simulation_(simulation),
      say_(std::move(say)),
      governor_(simulation.scene().tick_rate, may_step_down(simulation)) {
  for (const auto& [body, steps] : governor_.steps_down()) (void)dial_.overload({body, steps});
}

void OverloadControl::apply(std::vector<EffortChange>& efforts) {
  for (EffortChange& asked : efforts) asked = dial_.host(asked);
  if (next_) efforts.push_back(dial_.overload(*next_));
  next_.reset();
}

void OverloadControl::judge(const StepReport& report, double seconds) {
  if (governor_.steps_down().empty()) return;
  next_ = governor_.tick(seconds, work_in(report));
  if (next_) announce(*next_);
}

/// Returns the work of a tick for each body that may step down, in units that are comparable among bodies.
std::map<BodyId, double> OverloadControl::work_in(const StepReport& report) const {
  std::map<BodyId, double> work;
  for (const auto& [body, steps] : governor_.steps_down()) {
    const std::string& name = simulation_.name(body);
    for (const BodyReport& row : report.bodies)
      if (row.body == name)
        work[body] += static_cast<double>(1 + row.solver_iterations) *
                      static_cast<double>(simulation_.soft(body).elements());
  }
  return work;
}

void OverloadControl::announce(const EffortChange& change) const {
  const std::string& name = simulation_.name(change.body);
  if (change.steps_down == 0)
    say_(fmt::format("{} is solved at its configured effort again: the server has spare capacity", name));
  else
    say_(fmt::format("{}: solver effort is reduced by {} of {} steps: the server {}", name, change.steps_down,
                     max_steps_down,
                     change.steps_down > simulation_.soft_state(change.body).steps_down
                         ? "is overloaded"
                         : "has spare capacity again"));
}

std::string OverloadControl::stepped_down() const {
  std::string out;
  for (const auto& [body, steps] : governor_.steps_down())
    if (steps > 0)
      out += fmt::format("{}{}: effort reduced by {} steps, because the server is overloaded",
                         out.empty() ? "" : ", ", simulation_.name(body), steps);
  return out;
}

}  // namespace prosector
