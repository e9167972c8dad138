// Rigid-to-soft mass ratios of 1e-4, 1 and 1e4, each body on top. After 5 s of settling, the RMS speed over 1
// s and the penetration depth are measured; the latter is compared with the scene's contact_stiffness. The
// table is driven as a kinematic body, which keeps the bodies awake.

#include <fmt/format.h>

#include <cmath>

#include "server/physics/mechanics/soft/mechanical_energy.h"
#include "server/physics/mechanics/soft/soft_body.h"
#include "tests/bench/contact_run.h"

namespace prosector {
namespace {

constexpr double block_mass = 0.6, g = 9.81;  // kg, m/s²
constexpr double still = 1e-3;                // m/s

TickInput awake() {
  return driving(0, {{0, -0.05, 0}, Quat::Identity()});
}

SceneDesc rigid_on_top(double ratio) {
  SceneDesc scene;
  scene.rigid = {test::table(), test::part_body("plate", "box", {0.14, 0.02, 0.14}, {0, 0.0701, 0})};
  scene.rigid[1].material.mass = ratio * block_mass;
  scene.soft = {test::block()};
  if (ratio > 1) scene.soft[0].material.youngs_modulus = 1e8;  // softer tissue would be flattened
  return scene;
}

SceneDesc soft_on_top(double ratio) {
  SceneDesc scene;
  scene.rigid = {test::table(), test::part_body("plate", "box", {0.14, 0.02, 0.14}, {0, 0.0101, 0})};
  scene.rigid[1].material.mass = ratio * block_mass;
  scene.soft = {test::block()};
  scene.soft[0].pose.p.y() = 0.0503;
  return scene;
}

/// Returns the penetration depth of the block's deepest node in the plate, m.
double sunk(const Simulation& simulation) {
  const Pose to_plate = simulation.rigid_state(1).pose.inverse();
  const VecX& nodes = simulation.soft_state(2).motion.x;
  double deepest = -1;
  for (Eigen::Index i = 0; i < nodes.size(); i += 3) {
    const Vec3 x = to_plate * Vec3(nodes.segment<3>(i));
    if (std::abs(x.x()) < 0.07 && std::abs(x.z()) < 0.07) deepest = std::max(deepest, 0.01 - std::abs(x.y()));
  }
  return deepest;
}

void rest(ContactRows& rows, const SceneDesc& scene, const std::string& setting, double weight, int settle) {
  ContactRun run(scene);
  run.run(settle, awake());
  double rigid = 0, soft = 0;
  constexpr int ticks = 60;
  for (int i = 0; i < ticks; ++i) {
    run.step(awake());
    const Simulation& s = run.simulation();
    rigid += s.rigid_state(1).linear_velocity.squaredNorm() / ticks;
    soft += 2 * soft::kinetic_energy(s.soft(2).node_mass(), s.soft_state(2).motion.v) /
            s.soft(2).total_mass() / ticks;
  }
  // Contacts yield like a surface cell of the tissue with contact_stiffness times its stiffness, three times
  // as much at the edges.
  const SoftDesc& desc = scene.soft[0];
  const double pressure = weight / (desc.geometry.size.x() * desc.geometry.size.z());
  const double yields =
      pressure / desc.material.youngs_modulus * desc.geometry.surface_cell / scene.contact_stiffness;
  rows.add(run, setting, {"RMS plate speed", "mm/s", 1e3 * std::sqrt(rigid), 0, 1e3 * still});
  rows.add(run, setting, {"RMS tissue speed", "mm/s", 1e3 * std::sqrt(soft), 0, 1e3 * still});
  rows.add(
      run, setting,
      {"penetration depth", "mm", 1e3 * std::max(0.0, sunk(run.simulation())), 0, 1e3 * (3 * yields + 1e-5)});
}

}  // namespace

void ratio_case(ContactRows& rows, bool quick) {
  const int settle = quick ? 10 : 300;
  for (const double ratio : {1e-4, 1.0, 1e4}) {
    if (quick && ratio != 1) continue;
    rest(rows, rigid_on_top(ratio), fmt::format("plate on tissue, mass ratio {:.0e}", ratio),
         ratio * block_mass * g, settle);
    rest(rows, soft_on_top(ratio), fmt::format("tissue on a plate, mass ratio {:.0e}", ratio), block_mass * g,
         settle);
  }
}

}  // namespace prosector
