#include "server/session/run/run_meter.h"

#include <algorithm>

namespace prosector {

void RunMeter::add(const Simulation& simulation, const Roster& roster, const StepReport& report,
                   std::int64_t begun_ns, std::int64_t ended_ns) {
  last_end_ns_ = ended_ns;
  last_tick_ = simulation.time().tick;
  if (!start_) start_ = {last_tick_, last_end_ns_};
  if (!roster.members().empty() && !first_arrival_) first_arrival_ = {last_tick_, last_end_ns_};
  figures_.participants = std::max(figures_.participants, roster.participants());
  figures_.observers = std::max(figures_.observers, roster.observers());
  ++figures_.ticks;
  bool tissue_awake = false;
  for (BodyId b = 0; b < simulation.body_count(); ++b) {
    if (simulation.kind(b) != BodyKind::soft || simulation.asleep(b)) continue;
    tissue_awake = true;
    double& most = figures_.max_displacement_mm[simulation.name(b)];
    most = std::max(most, 1e3 * simulation.max_displacement(b));
  }
  steps_.add(report, tissue_awake, begun_ns, ended_ns);
}

double RunMeter::real_time_factor(const std::optional<Count>& since) const {
  if (!since || last_end_ns_ <= since->ns) return 0;
  return static_cast<double>(last_tick_ - since->tick) / tick_rate_ /
         (1e-9 * static_cast<double>(last_end_ns_ - since->ns));
}

RunFigures RunMeter::figures() const {
  RunFigures out = figures_;
  out.late_ticks = steps_.late();
  out.real_time_factor = real_time_factor(start_);
  out.real_time_factor_with_participants = real_time_factor(first_arrival_);
  return out;
}

}  // namespace prosector
