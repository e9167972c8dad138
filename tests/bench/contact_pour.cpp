// 200 rigid boxes are poured on a slab as soft as liver, and on a liver on a table. None may fall through.

#include <fmt/format.h>

#include <algorithm>

#include "server/physics/mechanics/collision/surface/triangle_surface.h"
#include "server/physics/mechanics/soft/soft_body.h"
#include "tests/bench/contact_run.h"

namespace prosector {
namespace {

constexpr double box = 0.016;        // m
constexpr double apart = 0.029;      // m, spacing: more than a box's diagonal
constexpr double tolerance = 0.002;  // m

/// Returns a scene with boxes in layers of 8 × 5, the lowest at height `over` m. The caller adds the tissue.
SceneDesc scene_of(int boxes, double over) {
  SceneDesc scene;
  scene.rigid = {test::table()};
  scene.rigid[0].geometry.parts[0].size = {6, 0.1, 6};
  for (int i = 0; i < boxes; ++i) {
    const int column = i % 8, row = i / 8 % 5, layer = i / 40;
    const Vec3 at(apart * (column - 3.5), over + apart * layer, apart * (row - 2));
    scene.rigid.push_back(test::part_body(fmt::format("box {}", i), "box", Vec3::Constant(box), at));
    scene.rigid.back().pose.q =
        Quat(Eigen::AngleAxisd(0.3 * (i % 7), Vec3(0.2, 1, 0.1 * (i % 3)).normalized()));
  }
  return scene;
}

SoftDesc slab() {
  SoftDesc tissue = test::block("slab");
  tissue.geometry.size = {0.24, 0.06, 0.18};
  tissue.pose.p.y() = tissue.geometry.size.y() / 2;
  return tissue;
}

SoftDesc liver() {
  SoftDesc tissue;
  tissue.name = tissue.geometry.shape = "liver";
  tissue.geometry.size = {0.24, 0.11, 0.17};
  tissue.pose.p = {0, 0.06, 0};
  tissue.geometry.cell = 0.02;
  tissue.geometry.surface_cell = 0.01;
  return tissue;
}

/// Returns the depth of a point in a box, m; negative outside.
double depth_in(const Pose& at, const Vec3& x) {
  return box / 2 - (at.inverse() * x).cwiseAbs().maxCoeff();
}

/// Returns the largest penetration depth, m: of box corners in tissue and table, and of tissue vertices in
/// boxes.
double deepest(const Simulation& s, int boxes) {
  const BodyId tissue = static_cast<BodyId>(1 + boxes);
  const Anatomy& anatomy = s.soft(tissue).anatomy();
  TriangleMesh now = anatomy.surface;
  for (std::size_t v = 0; v < now.positions.size(); ++v)
    now.positions[v] = anatomy.embedding.apply(v, s.soft_state(tissue).motion.x.data());
  const collision::TriangleSurface surface(now);
  double worst = 0;
  for (int i = 0; i < boxes; ++i) {
    const Pose pose = s.rigid_state(static_cast<BodyId>(1 + i)).pose;
    for (const Vec3& vertex : now.positions) worst = std::max(worst, depth_in(pose, vertex));
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 x = pose * (box / 2 * Vec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1));
      const auto nearest = surface.nearest(x);
      if (nearest && surface.is_inside(x, *nearest)) worst = std::max(worst, nearest->distance);
      worst = std::max(worst, -x.y());
    }
  }
  return worst;
}

void pour(ContactRows& rows, const SoftDesc& tissue, double over, const CompileOptions& options, bool quick) {
  const int boxes = quick ? 10 : 200;
  SceneDesc scene = scene_of(boxes, over);
  scene.soft = {tissue};
  ContactRun run(scene, options);
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
  const std::string setting = fmt::format("{} boxes of {:.0f} mm on a {}", boxes, 1e3 * box, tissue.name);
  rows.add(run, setting,
           {"largest penetration depth", "mm", 1e3 * deepest(run.simulation(), boxes), 0, 1e3 * tolerance},
           {{"slowest_ms", slowest_ms}, {"tets", tet_count(run.simulation())}});
  rows.add(run, setting, {"largest box speed in the last second", "m/s", fastest, 0, 0.05});
  rows.add(
      run, setting,
      {"energy gain since the start", "J", std::max(0.0, run.highest_energy() - start), 0, 1e-3 * start});
}

}  // namespace

void pour_case(ContactRows& rows, bool quick) {
  pour(rows, slab(), 0.078, test::options(), quick);
  if (quick) return;
  CompileOptions shaped;  // default options
  shaped.threads = 1;
  pour(rows, liver(), 0.14, shaped, quick);
}

}  // namespace prosector
