// The presses of the finite-layer table in real time: 60 ticks/s, two threads, real-time solver effort, and
// contacts of default stiffness over the contact area.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "tests/bench/contact_run.h"
#include "tests/bench/finite_layer.h"
#include "tests/physics/pressed_layer.h"
#include "tests/physics/under_ball.h"

namespace prosector {
namespace {

constexpr int down = 15, held = 30;  // ticks
constexpr double speed = 0.02;       // m/s, speed of the sliding ball
constexpr double budget = 8;         // ms, wall time per tick

struct LayerRung {
  const char* element;
  double cells;      // cells per contact radius √(R·depth)
  double tolerance;  // of the linear solver
};
/// The first mesh must run in real time, with a force within 5 % and without jumps. The second must give a
/// smooth force anywhere in a cell.
constexpr LayerRung rungs[] = {
    {"tet10", 0.5, 1e-2}, {"tet10", 0.75, 1e-2}, {"tet4", 1, 1e-3}, {"tet4", 0.5, 1e-3}};

/// Presses within 0.25 s, holds, and slides over one cell.
void press(ContactRows& rows, const LayerPress& press, const LayerRung& rung, bool asked) {
  const double contact_radius = std::sqrt(press.radius * press.depth), cell = contact_radius / rung.cells;
  SceneDesc scene = layer_scene(press, rung.element, cell);
  SoftDesc& layer = scene.soft[0];
  layer.contact.points = ContactPoints::surface;
  layer.configuration.solver_tolerance = rung.tolerance;
  CompileOptions options;
  options.threads = 2;
  options.anatomy = [&](const SoftDesc&) -> std::optional<Anatomy> {
    constexpr double growth = 3;  // cells grow far from the ball
    return test::pressed_layer(press.height, contact_radius + cell, cell, growth);
  };
  ContactRun run(scene, options);
  const auto step_to = [&](double x, double depth) {
    run.step(driving(0, {{x, press.radius - depth, 0.2 * cell}, Quat::Identity()}));
  };
  for (int tick = 1; tick <= down + held; ++tick)
    step_to(0, press.depth * std::min(1.0, static_cast<double>(tick) / down));
  const double force = test::pressing_force(run.simulation());
  double give = 0;  // m
  std::uint32_t points = 0;
  for (const Exchange& touch : run.simulation().exchanges()) {
    give = std::max(give, touch.depth);
    points += touch.points;
  }
  double last = force, jump = 0, least = force, most = force;
  for (double x = 0; x < cell; x += speed * run.h()) {
    step_to(x, press.depth);
    const double now = test::pressing_force(run.simulation());
    jump = std::max(jump, std::abs(now / last - 1));
    least = std::min(least, now);
    most = std::max(most, now);
    last = now;
  }
  const std::string setting = fmt::format("{}, {}, {} cells", name(press), rung.element, rung.cells);
  const ReportRow more = {{"element", rung.element},
                          {"cells_per_contact_radius", rung.cells},
                          {"tets", tet_count(run.simulation())},
                          {"points", points},
                          {"wall_ms", run.median_wall_ms()},
                          {"cpu_ms", run.median_ms()}};
  const auto within = [&](double tolerance) { return asked ? std::optional(tolerance) : std::nullopt; };
  rows.add(run, setting, {"force over tabulated force", "1", force / press.force, 1, within(0.05)}, more);
  rows.add(run, setting, {"sliding: largest change per tick", "1", jump, 0, within(0.02)}, more);
  rows.add(run, setting, {"sliding: relative force range", "1", (most - least) / force, 0, std::nullopt},
           more);
  rows.add(run, setting, {"contact compression over depth", "1", give / press.depth, 0, std::nullopt}, more);
  rows.add(run, setting, {"median CPU time per tick", "ms", run.median_ms(), 0, std::nullopt}, more);
  rows.add(run, setting, {"median wall time per tick", "ms", run.median_wall_ms(), 0, within(budget)}, more);
}

}  // namespace

void layer_case(ContactRows& rows, bool quick) {
  for (const LayerPress& p : layer_presses) {
    press(rows, p, rungs[0], true);
    if (quick) return;
  }
  for (const LayerPress& p : layer_presses) press(rows, p, rungs[1], false);
  for (std::size_t i = 0; i < 3; ++i)  // presses of the thin layer
    for (const LayerRung& rung : std::span(rungs).subspan(2)) press(rows, layer_presses[i], rung, false);
}

}  // namespace prosector
