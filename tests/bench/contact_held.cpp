// Cost of contact: a liver of 5,000 tetrahedra on a table, held and swung by a hand, with a scene's default
// settings. The limit is half of a 60 Hz tick on one core.

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "server/physics/mechanics/soft/soft_body.h"
#include "tests/bench/contact_run.h"

namespace prosector {
namespace {

constexpr double cell = 0.0166, coarse_cell = 0.04;  // m
constexpr double budget = 1e3 / 60 / 2;              // ms
constexpr double swing = 0.02, period = 2;           // m, s

SceneDesc scene_of(double cell) {
  SceneDesc scene;
  scene.rigid = {test::table()};
  SoftDesc& liver = scene.soft.emplace_back();
  liver.name = "liver";
  liver.geometry.shape = "liver";
  liver.geometry.size = {0.24, 0.11, 0.17};
  liver.pose.p = {0, 0.06, 0};
  liver.geometry.cell = cell;
  liver.geometry.surface_cell = cell / 2;
  return scene;
}

/// Returns the hand's position with the fingers at the body's highest vertex.
Vec3 over(const Simulation& s, BodyId body) {
  const Anatomy& anatomy = s.soft(body).anatomy();
  Vec3 top(0, -1, 0);
  for (std::size_t v = 0; v < anatomy.surface.positions.size(); ++v) {
    const Vec3 x = anatomy.embedding.apply(v, s.soft_state(body).motion.x.data());
    if (x.y() > top.y()) top = x;
  }
  return top + Vec3(-0.004, 0.013, 0.045);
}

}  // namespace

void held_case(ContactRows& rows, bool quick) {
  CompileOptions options;
  options.threads = 1;
  ContactRun run(scene_of(quick ? coarse_cell : cell), options);
  const Vec3 at = over(run.simulation(), 1);
  run.step(test::appear(at));
  run.step(test::event(HandEvent::Kind::grasp, at));
  run.run(30, test::target(at));
  run.forget_times();
  std::size_t points = 0;
  const int ticks = quick ? 30 : 360;
  for (int i = 0; i < ticks; ++i) {
    const double phase = 2 * std::numbers::pi * i * run.h() / period;
    run.step(test::target(at + Vec3(swing * std::sin(phase), swing * (1 - std::cos(phase)), 0)));
    for (const Exchange& touch : run.simulation().exchanges()) points += touch.points;
  }
  const HandState& hand = run.simulation().hands()[0];
  const std::string setting = "liver on a table, swung by a hand";
  rows.add(run, setting, {"median CPU time per tick", "ms", run.median_ms(), 0, budget},
           {{"tets", tet_count(run.simulation())},
            {"nodes", run.simulation().soft(1).nodes()},
            {"surface_vertices", run.simulation().surface(1).positions.size()},
            {"held", hand.holding.has_value()},
            {"points_on_table", static_cast<double>(points) / ticks}});
  rows.add(run, setting,
           {"95th percentile of CPU time per tick", "ms", run.quantile_ms(0.95), 0, std::nullopt});
}

}  // namespace prosector
