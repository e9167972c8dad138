// Wire conversion of statistics of the server and of deformables: ServerStatus, BodyStatus.

#include <algorithm>
#include <iterator>

#include "idl/wire/primitives.h"

namespace prosector {
namespace {

constexpr double max_statistic = 1e12;  // in any unit: far above the values of a working server

bool is_valid_error_map(const ErrorMap& m) {
  std::size_t values = 1;
  for (const std::uint8_t side : m.size) {
    if (side > max_error_map_side) return false;
    values *= side;
  }
  return m.levels.size() == values && within(m.cell, 0, max_coordinate) && within(m.corner, max_coordinate);
}

}  // namespace

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
  w.error = m.error;
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
  m.error = w.error;
  return {};
}

Refusal check(ServerStatus& m) {
  Checks checks;
  checks.that(within(m.real_time_factor, 0, max_statistic), "the server's real-time factor is out of range")
      .that(within(m.step_ms_p50, 0, max_statistic) && within(m.step_ms_p99, 0, max_statistic),
            "the server's duration of a step is out of range")
      .that(within(m.solver_residual, 0, max_statistic), "residual out of range")
      .that(within(m.energy, -max_statistic, max_statistic), "energy out of range")
      .that(within(m.error, -1, max_statistic), "error out of range")
      .that(valid_text(m.degraded), "degraded not valid text");
  for (const double ms : m.phase_ms)
    checks.that(within(ms, 0, max_statistic), "the server's duration of a phase of the step is out of range");
  return checks.refusal();
}

void to_wire(const BodyStatus& m, prosector_BodyStatus& w, WireArena& arena) {
  w.body = m.body;
  w.time = to_wire(m.time);
  w.asleep = m.asleep;
  w.converged = m.converged;
  w.substeps = m.substeps;
  w.step = m.step;
  w.newton_iterations = m.newton_iterations;
  w.solver_iterations = m.solver_iterations;
  w.residual = m.residual;
  w.correction = m.correction;
  w.error = m.error;
  w.expected_ms = m.expected_ms;
  w.stepped_down = m.stepped_down;
  make_sequence<prosector_Price>(w.prices, m.prices.size(), arena);
  for (std::size_t i = 0; i < m.prices.size(); ++i) w.prices._buffer[i] = {m.prices[i].error, m.prices[i].ms};
  w.parts[0] = m.parts.discretisation;
  w.parts[1] = m.parts.model;
  w.parts[2] = m.parts.solver;
  w.parts[3] = m.parts.time;
  w.press_error = m.press_error;
  to_wire(m.error_map.corner, w.error_map.corner);
  w.error_map.cell = m.error_map.cell;
  std::copy(m.error_map.size.begin(), m.error_map.size.end(), w.error_map.size);
  make_sequence<std::uint8_t>(w.error_map.levels, m.error_map.levels.size(), arena);
  std::copy(m.error_map.levels.begin(), m.error_map.levels.end(), w.error_map.levels._buffer);
}

Refusal from_wire(const prosector_BodyStatus& w, BodyStatus& m) {
  if (!sequence_within(w.prices, max_configuration_costs)) return "too many prices";
  m.body = w.body;
  m.time = from_wire(w.time);
  m.asleep = w.asleep != 0;
  m.converged = w.converged != 0;
  m.substeps = w.substeps;
  m.step = w.step;
  m.newton_iterations = w.newton_iterations;
  m.solver_iterations = w.solver_iterations;
  m.residual = w.residual;
  m.correction = w.correction;
  m.error = w.error;
  m.expected_ms = w.expected_ms;
  m.stepped_down = w.stepped_down;
  m.prices.clear();
  for (std::size_t i = 0; i < w.prices._length; ++i)
    m.prices.push_back({w.prices._buffer[i].error, w.prices._buffer[i].ms});
  m.parts = {w.parts[0], w.parts[1], w.parts[2], w.parts[3]};
  m.press_error = w.press_error;
  m.error_map.corner = from_wire(w.error_map.corner);
  m.error_map.cell = w.error_map.cell;
  std::copy(std::begin(w.error_map.size), std::end(w.error_map.size), m.error_map.size.begin());
  if (!sequence_within(w.error_map.levels, max_error_map_values)) return "error map too large";
  m.error_map.levels.assign(w.error_map.levels._buffer,
                            w.error_map.levels._buffer + w.error_map.levels._length);
  return {};
}

Refusal check(BodyStatus& m) {
  Checks checks;
  for (const Price& price : m.prices)
    checks.that(within(price.error, 0, max_statistic) && within(price.ms, 0, max_statistic),
                "price out of range");
  return checks.that(m.prices.size() <= max_configuration_costs, "too many prices")
      .that(m.body < max_bodies, "no such body")
      .that(within(m.step, 0, max_statistic), "step out of range")
      .that(within(m.newton_iterations, 0, max_statistic) && within(m.solver_iterations, 0, max_statistic),
            "iterations out of range")
      .that(within(m.residual, 0, max_statistic), "residual out of range")
      .that(within(m.correction, 0, max_statistic), "correction out of range")
      .that(within(m.error, -1, max_statistic) && within(m.press_error, -1, max_statistic),
            "error out of range")
      .that(within(m.parts.discretisation, -max_statistic, max_statistic) &&
                within(m.parts.model, -max_statistic, max_statistic) &&
                within(m.parts.solver, 0, max_statistic) && within(m.parts.time, 0, max_statistic),
            "a component of the body's estimated error is out of range")
      .that(within(m.expected_ms, -1, max_statistic), "expectation out of range")
      .that(is_valid_error_map(m.error_map),
            "the size, position or values of the body's error map are inconsistent")
      .that(m.stepped_down <= max_steps_down, "the reduction of the body's solver effort is out of range")
      .refusal();
}

}  // namespace prosector
