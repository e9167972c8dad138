// The presses of the finite-layer table on tissue that names its shape and material only: what a scene feels
// like by default, in real time.

#include <algorithm>

#include "tests/bench/contact_run.h"
#include "tests/bench/finite_layer.h"
#include "tests/physics/usual_press.h"

namespace prosector {
namespace {

constexpr double budget = 4;  // ms, wall time per tick

void press(ContactRows& rows, const LayerPress& press) {
  CompileOptions options;
  options.threads = 2;
  ContactRun run(test::usual_layer(press.height, press.poisson_ratio, press.radius), options);
  const test::Slide slide = test::press_and_slide(run.simulation(), press.radius, press.depth,
                                                  [&](const TickInput& input) { run.step(input); });
  double give = 0;  // m
  for (const Exchange& touch : run.simulation().exchanges()) give = std::max(give, touch.depth);
  const ReportRow more = {
      {"tets", tet_count(run.simulation())}, {"wall_ms", run.median_wall_ms()}, {"cpu_ms", run.median_ms()}};
  const std::string setting = name(press);
  rows.add(run, setting, {"force over tabulated force", "1", slide.force / press.force, 1, 0.1}, more);
  rows.add(run, setting, {"sliding: least force", "1", slide.least / press.force, 1, 0.1}, more);
  rows.add(run, setting, {"sliding: greatest force", "1", slide.most / press.force, 1, 0.1}, more);
  rows.add(run, setting, {"sliding: largest change per tick", "1", slide.largest_change, 0, 0.02}, more);
  rows.add(run, setting, {"contact compression over depth", "1", give / press.depth, 0, std::nullopt}, more);
  rows.add(run, setting, {"median CPU time per tick", "ms", run.median_ms(), 0, std::nullopt}, more);
  rows.add(run, setting, {"median wall time per tick", "ms", run.median_wall_ms(), 0, budget}, more);
}

}  // namespace

void usual_case(ContactRows& rows, bool quick) {
  for (const LayerPress& p : layer_presses) {
    press(rows, p);
    if (quick) return;
  }
}

}  // namespace prosector
