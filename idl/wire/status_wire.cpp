// How the server does: ServerStatus.

#include "idl/wire/primitives.h"

namespace prosector {

void to_wire(const ServerStatus& m, prosector_ServerStatus& w, WireArena&) {
  w.time = to_wire(m.time);
  w.real_time_factor = m.real_time_factor;
  w.step_ms_p50 = m.step_ms_p50;
  w.step_ms_p99 = m.step_ms_p99;
  static_assert(sizeof w.phase_ms == step_phases * sizeof(double));
  for (std::size_t i = 0; i < step_phases; ++i) w.phase_ms[i] = m.phase_ms[i];
  w.solver_residual = m.solver_residual;
  w.energy = m.energy;
  w.participants = m.participants;
  w.observers = m.observers;
  w.awake_bodies = m.awake_bodies;
  w.asleep_bodies = m.asleep_bodies;
  w.invalid_dropped = m.invalid_dropped;
  w.state_hash = m.state_hash;
  to_wire(m.degraded, w.degraded);
}

Refusal from_wire(const prosector_ServerStatus& w, ServerStatus& m) {
  m.time = from_wire(w.time);
  m.real_time_factor = w.real_time_factor;
  m.step_ms_p50 = w.step_ms_p50;
  m.step_ms_p99 = w.step_ms_p99;
  for (std::size_t i = 0; i < step_phases; ++i) m.phase_ms[i] = w.phase_ms[i];
  m.solver_residual = w.solver_residual;
  m.energy = w.energy;
  m.participants = w.participants;
  m.observers = w.observers;
  m.awake_bodies = w.awake_bodies;
  m.asleep_bodies = w.asleep_bodies;
  m.invalid_dropped = w.invalid_dropped;
  m.state_hash = w.state_hash;
  m.degraded = from_wire(w.degraded);
  return nullptr;
}

Refusal check(ServerStatus& m) {
  constexpr double huge = 1e12;  // of whatever unit: no figure of a healthy server comes near
  Checks checks;
  checks.that(within(m.real_time_factor, 0, huge), "real-time factor out of range")
      .that(within(m.step_ms_p50, 0, huge) && within(m.step_ms_p99, 0, huge), "step time out of range")
      .that(within(m.solver_residual, 0, huge), "residual out of range")
      .that(within(m.energy, -huge, huge), "energy out of range")
      .that(valid_text(m.degraded), "degraded not valid text");
  for (const double ms : m.phase_ms) checks.that(within(ms, 0, huge), "phase time out of range");
  return checks.refusal();
}

}  // namespace prosector
