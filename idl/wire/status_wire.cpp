// Wire conversion of statistics of the server and of deformables: ServerStatus, BodyStatus.

#include "idl/wire/fields.h"

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

template <class Io>
void fields(Io& io, MessageOf<Io, ServerStatus>& m, WireOf<Io, prosector_ServerStatus>& w) {
  io(m.time, w.time);
  io(m.real_time_factor, w.real_time_factor);
  io(m.step_ms_p50, w.step_ms_p50);
  io(m.step_ms_p99, w.step_ms_p99);
  static_assert(sizeof w.phase_ms == step_phases * sizeof(double));
  for (std::size_t i = 0; i < step_phases; ++i) io(m.phase_ms[i], w.phase_ms[i]);
  io(m.solver_residual, w.solver_residual);
  io(m.energy, w.energy);
  io(m.participants, w.participants);
  io(m.observers, w.observers);
  io(m.awake_bodies, w.awake_bodies);
  io(m.asleep_bodies, w.asleep_bodies);
  io(m.invalid_dropped, w.invalid_dropped);
  io(m.state_hash, w.state_hash);
  io(m.degraded, w.degraded);
  io(m.error, w.error);
}

template <class Io>
void fields(Io& io, MessageOf<Io, Price>& m, WireOf<Io, prosector_Price>& w) {
  io(m.error, w.error);
  io(m.ms, w.ms);
}

template <class Io>
void fields(Io& io, MessageOf<Io, ErrorMap>& m, WireOf<Io, prosector_ErrorMap>& w) {
  io(m.corner, w.corner);
  io(m.cell, w.cell);
  for (std::size_t i = 0; i < 3; ++i) io(m.size[i], w.size[i]);
  io.list(m.levels, w.levels, max_error_map_values, "error map too large",
          [](auto& items, auto& level, auto& field) { items(level, field); });
}

template <class Io>
void fields(Io& io, MessageOf<Io, BodyStatus>& m, WireOf<Io, prosector_BodyStatus>& w) {
  io(m.body, w.body);
  io(m.time, w.time);
  io(m.asleep, w.asleep);
  io(m.converged, w.converged);
  io(m.substeps, w.substeps);
  io(m.step, w.step);
  io(m.newton_iterations, w.newton_iterations);
  io(m.solver_iterations, w.solver_iterations);
  io(m.residual, w.residual);
  io(m.correction, w.correction);
  io(m.error, w.error);
  io(m.expected_ms, w.expected_ms);
  io(m.stepped_down, w.stepped_down);
  io.list(m.prices, w.prices, max_configuration_costs, "too many configuration costs",
          [](auto& items, auto& price, auto& field) { fields(items, price, field); });
  io(m.parts.discretisation, w.parts[0]);
  io(m.parts.model, w.parts[1]);
  io(m.parts.solver, w.parts[2]);
  io(m.parts.time, w.parts[3]);
  io(m.press_error, w.press_error);
  fields(io, m.error_map, w.error_map);
}

}  // namespace

PROSECTOR_WIRE_BY_FIELDS(ServerStatus);

Refusal check(ServerStatus& m) {
  Checks checks;
  checks.that(within(m.real_time_factor, 0, max_statistic), "the server's real-time factor is out of range")
      .that(within(m.step_ms_p50, 0, max_statistic) && within(m.step_ms_p99, 0, max_statistic),
            "the server's duration of a step is out of range")
      .that(within(m.solver_residual, 0, max_statistic), "residual out of range")
      .that(within(m.energy, -max_statistic, max_statistic), "energy out of range")
      .that(within(m.error, -1, max_statistic), "error out of range")
      .that(valid_text(m.degraded), "the list of degraded bodies is not valid text");
  for (const double ms : m.phase_ms)
    checks.that(within(ms, 0, max_statistic), "the server's duration of a phase of the step is out of range");
  return checks.refusal();
}

PROSECTOR_WIRE_BY_FIELDS(BodyStatus);

Refusal check(BodyStatus& m) {
  Checks checks;
  for (const Price& price : m.prices)
    checks.that(within(price.error, 0, max_statistic) && within(price.ms, 0, max_statistic),
                "the error or CPU time of a model configuration is out of range");
  return checks.that(m.prices.size() <= max_configuration_costs, "too many configuration costs")
      .that(m.body < max_bodies, "no such body")
      .that(within(m.step, 0, max_statistic), "step out of range")
      .that(within(m.newton_iterations, 0, max_statistic) && within(m.solver_iterations, 0, max_statistic),
            "iterations out of range")
      .that(within(m.residual, 0, max_statistic), "residual out of range")
      .that(within(m.correction, 0, max_statistic),
            "the displacement of the last Newton step is out of range")
      .that(within(m.error, -1, max_statistic) && within(m.press_error, -1, max_statistic),
            "error out of range")
      .that(within(m.parts.discretisation, -max_statistic, max_statistic) &&
                within(m.parts.model, -max_statistic, max_statistic) &&
                within(m.parts.solver, 0, max_statistic) && within(m.parts.time, 0, max_statistic),
            "a component of the body's estimated error is out of range")
      .that(within(m.expected_ms, -1, max_statistic), "the expected CPU time of a body is out of range")
      .that(is_valid_error_map(m.error_map),
            "the size, position or values of the body's error map are inconsistent")
      .that(m.stepped_down <= max_steps_down, "the reduction of the body's solver effort is out of range")
      .refusal();
}

}  // namespace prosector
