#include "server/session/run/session_status.h"

namespace prosector {

ServerStatus status_of(const StepMeter& meter, const Session& session, const Bus& bus) {
  const LastSecond last = meter.last_second();
  const LastStep& step = meter.last_step();
  ServerStatus out;
  out.real_time_factor = last.real_time_factor;
  out.step_ms_p50 = last.step_ms_p50;
  out.step_ms_p99 = last.step_ms_p99;
  out.phase_ms = last.phase_ms;
  out.solver_residual = last.solver_residual;
  out.energy = step.energy;
  out.participants = session.roster().participants();
  out.observers = session.roster().observers();
  out.awake_bodies = step.awake;
  out.asleep_bodies = step.asleep;
  out.invalid_dropped = bus.counters().dropped_total + session.output().dropped_total();
  return out;
}

}  // namespace prosector
