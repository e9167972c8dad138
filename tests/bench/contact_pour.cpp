// 200 rigid boxes poured on a slab as soft as liver: they pile up or roll off, and none falls through.

#include <fmt/format.h>

#include <algorithm>

#include "server/physics/soft/soft_body.h"
#include "tests/bench/contact_run.h"

namespace prosector {
namespace {

constexpr double box = 0.016;    // m
constexpr double apart = 0.029;  // m: more than a box' diagonal, however it is turned
const Vec3 slab(0.24, 0.06, 0.18);
constexpr double tolerance =
    0.002;  // m: how deep a box's middle may be below where its half height would bear it

SceneDesc scene_of(int boxes) {
  SceneDesc scene;
  scene.rigid = {test::table()};
  scene.rigid[0].parts[0].size = {6, 0.1, 6};
  for (int i = 0; i < boxes; ++i) {
    const int column = i % 8, row = i / 8 % 5, layer = i / 40;
    const Vec3 at(apart * (column - 3.5), 0.078 + apart * layer, apart * (row - 2));
    scene.rigid.push_back(test::part_body(fmt::format("box {}", i), "box", Vec3::Constant(box), at));
    scene.rigid.back().pose.q =
        Quat(Eigen::AngleAxisd(0.3 * (i % 7), Vec3(0.2, 1, 0.1 * (i % 3)).normalized()));
  }
  SoftDesc& tissue = scene.soft.emplace_back(test::block("slab"));
  tissue.size = slab;
  tissue.pose.p.y() = slab.y() / 2;
  return scene;
}

/// Of the slab's top straight above or below a point of the room, m; 0, the table's: the slab is not there.
double ground_at(const Anatomy& anatomy, const VecX& x, const Vec3& at) {
  for (const auto& corners : anatomy.surface.triangles) {
    std::array<Vec3, 3> p;
    bool top = true;
    for (std::size_t k = 0; k < 3; ++k) {
      top = top && anatomy.surface.positions[corners[k]].y() > slab.y() - 1e-6;
      p[k] = anatomy.embedding.apply(corners[k], x.data());
    }
    if (!top) continue;
    const auto cross = [](const Vec3& u, const Vec3& v) { return u.z() * v.x() - u.x() * v.z(); };
    const double whole = cross(p[1] - p[0], p[2] - p[0]);
    const double b = cross(at - p[0], p[2] - p[0]) / whole, c = cross(p[1] - p[0], at - p[0]) / whole;
    if (b >= 0 && c >= 0 && b + c <= 1) return (1 - b - c) * p[0].y() + b * p[1].y() + c * p[2].y();
  }
  return 0;
}

/// How far the lowest box's centre is below half a box over what is under it, m.
double deepest(const Simulation& s, int boxes) {
  const BodyId tissue = static_cast<BodyId>(1 + boxes);
  double worst = 0;
  for (int i = 0; i < boxes; ++i) {
    const Vec3 at = s.rigid_state(static_cast<BodyId>(1 + i)).pose.p;
    const double ground = ground_at(s.soft(tissue).anatomy(), s.soft_state(tissue).motion.x, at);
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
    if (start == 0 && report.asleep_bodies == 0) start = run.energy();  // what sleeps is not counted
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
