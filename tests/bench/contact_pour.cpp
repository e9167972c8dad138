// 200 rigid boxes poured on a slab as soft as liver: they pile up or roll off, and none falls through.

#include <fmt/format.h>

#include <algorithm>

#include "server/physics/soft/soft_body.h"
#include "tests/bench/contact_run.h"

namespace prosector {
namespace {

constexpr double box = 0.016;  // m
const Vec3 slab(0.24, 0.06, 0.18);
constexpr double tolerance =
    0.002;  // m: how deep a box's middle may be below where its half height would bear it

SceneDesc scene_of(int boxes) {
  SceneDesc scene;
  scene.rigid = {test::table()};
  scene.rigid[0].parts[0].size = {6, 0.1, 6};
  for (int i = 0; i < boxes; ++i) {
    const int column = i % 10, row = i / 10 % 5, layer = i / 50;
    const Vec3 at(0.02 * (column - 4.5) + 0.002 * (layer % 2), 0.075 + 0.022 * layer,
                  0.024 * (row - 2) + 0.001 * (column % 3));
    scene.rigid.push_back(test::part_body(fmt::format("box {}", i), "box", Vec3::Constant(box), at));
    scene.rigid.back().pose.q =
        Quat(Eigen::AngleAxisd(0.3 * (i % 7), Vec3(0.2, 1, 0.1 * (i % 3)).normalized()));
  }
  SoftDesc& tissue = scene.soft.emplace_back(test::block("slab"));
  tissue.size = slab;
  tissue.pose.p.y() = slab.y() / 2;
  return scene;
}

/// How far the lowest box's centre is below half a box over the slab's nodes under it, or over the table, m.
double deepest(const Simulation& s, int boxes) {
  const BodyId tissue = static_cast<BodyId>(1 + boxes);
  const Anatomy& anatomy = s.soft(tissue).anatomy();
  const VecX& x = s.soft_state(tissue).motion.x;
  std::vector<Vec3> top;
  for (std::size_t v = 0; v < anatomy.surface.positions.size(); ++v)
    if (anatomy.surface.positions[v].y() > slab.y() - 1e-6)
      top.push_back(anatomy.embedding.apply(v, x.data()));
  double worst = 0;
  for (int i = 0; i < boxes; ++i) {
    const Vec3 at = s.rigid_state(static_cast<BodyId>(1 + i)).pose.p;
    double ground = 0, nearest = 0.02;
    for (const Vec3& p : top) {
      const double away = std::hypot(p.x() - at.x(), p.z() - at.z());
      if (away >= nearest) continue;
      nearest = away;
      ground = p.y();
    }
    worst = std::max(worst, ground + box / 2 - at.y());
  }
  return worst;
}

}  // namespace

void pour_case(ContactRows& rows, bool quick) {
  const int boxes = quick ? 10 : 200;
  ContactRun run(scene_of(boxes));
  double fastest = 0, slowest_ms = 0, start = 0;
  const int ticks = quick ? 30 : 360;
  for (int i = 0; i < ticks; ++i) {
    const StepReport& report = run.step();
    if (i == 0) start = run.energy();
    slowest_ms = std::max(slowest_ms, 1e3 * report.total_seconds);
    if (i < ticks - 60) continue;
    for (int b = 1; b <= boxes; ++b)
      fastest =
          std::max(fastest, run.simulation().rigid_state(static_cast<BodyId>(b)).linear_velocity.norm());
  }
  const std::string setting = fmt::format("{} boxes of {:.0f} mm on a slab", boxes, 1e3 * box);
  rows.add(
      run, setting,
      {"deepest box in tissue or table", "mm", 1e3 * deepest(run.simulation(), boxes), 0, 1e3 * tolerance},
      {{"slowest_ms", slowest_ms}, {"tets", run.simulation().tet_count()}});
  rows.add(run, setting, {"fastest box in the last second", "m/s", fastest, 0, 0.05});
  rows.add(
      run, setting,
      {"energy gained since the start", "J", std::max(0.0, run.highest_energy() - start), 0, 1e-3 * start});
}

}  // namespace prosector
