// Sheets that touch themselves.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "server/physics/collision/triangle_crossing.h"
#include "server/physics/contact/element_surface.h"
#include "server/physics/soft/soft_body.h"
#include "tests/physics/scenes.h"

namespace prosector::test {
namespace {

ElementSurface elements(const Simulation& simulation, BodyId body) {
  ElementSurface out(simulation.soft(body).anatomy());
  out.move(simulation.soft_state(body).motion.x);
  return out;
}

std::uint32_t count(const ElementSurface& of) {
  return static_cast<std::uint32_t>(of.tree().order().size());
}

bool cross(const Triangle& a, const Triangle& b) {
  const Vec3 lo = a[0].cwiseMin(a[1]).cwiseMin(a[2]), hi = a[0].cwiseMax(a[1]).cwiseMax(a[2]);
  const Vec3 other_lo = b[0].cwiseMin(b[1]).cwiseMin(b[2]), other_hi = b[0].cwiseMax(b[1]).cwiseMax(b[2]);
  if ((lo.array() > other_hi.array()).any() || (other_lo.array() > hi.array()).any()) return false;
  return crossing(a, b).count > 0;
}

/// How many pairs of elements that are `apart` (m) at rest are through each other.
int self_crossings(const Simulation& simulation, BodyId body, double apart) {
  const ElementSurface own = elements(simulation, body);
  int sum = 0;
  for (std::uint32_t s = 0; s < count(own); ++s)
    for (std::uint32_t t = s + 1; t < count(own); ++t)
      if (cross(own.now(s), own.now(t)) &&
          closest(own.at_rest(s), own.at_rest(t)).squared_distance > apart * apart)
        ++sum;
  return sum;
}

SoftDesc sheet(const std::string& name, const std::string& model) {
  SoftDesc soft;
  soft.name = name;
  soft.shape = "sheet";
  soft.model = model;
  soft.size = {0.3, 0.006, 0.12};
  soft.cell = 0.012;
  soft.youngs_modulus = 3e4;
  return soft;
}

double energy(const StepReport& report) {
  return report.kinetic_energy + report.elastic_energy + report.potential_energy;
}

/// Falls on its edge, leaning a little, and folds over onto itself.
SceneDesc falling_on_its_edge() {
  SceneDesc scene;
  scene.rigid = {table()};
  scene.soft = {sheet("sheet", "xpbd")};
  scene.soft[0].pose.p = {0, 0.18, 0};
  scene.soft[0].pose.q = Quat(Eigen::AngleAxisd(std::numbers::pi / 2 - 0.15, Vec3::UnitZ()));
  return scene;
}

struct Folding {
  int crossings = 0;
  double start = 0, highest = 0;  // J
};

Folding fold(SceneDesc scene, bool self_contact) {
  Folding out;
  scene.soft[0].self_contact = self_contact;
  Simulation simulation(scene, options());
  for (int tick = 0; tick < 170; ++tick) {
    const double now = energy(simulation.step({}));
    if (tick == 0) out.start = now;
    out.highest = std::max(out.highest, now - out.start);
    if (tick > 20 && tick % 10 == 0)
      out.crossings = std::max(out.crossings, self_crossings(simulation, 1, 0.03));
  }
  EXPECT_TRUE(simulation.soft_state(1).motion.x.allFinite());
  return out;
}

TEST(Layers, FoldedSheetDoesNotPassThroughItself) {
  const SceneDesc scene = falling_on_its_edge();
  EXPECT_GT(fold(scene, false).crossings, 0) << "nothing to prove";
  const Folding folded = fold(scene, true);
  EXPECT_EQ(folded.crossings, 0);
  EXPECT_LT(folded.highest, 0.01 * folded.start) << "J gained";
}

TEST(Layers, SameHashForAnyThreadCountAndAfterRestore) {
  SceneDesc scene = falling_on_its_edge();
  scene.soft[0].self_contact = true;
  Simulation one(scene, options(1)), two(scene, options(2)), restored(scene, options(1));
  run(one, 30);
  run(two, 30);
  EXPECT_EQ(one.state_hash(), two.state_hash());
  restored.restore(one.checkpoint());
  run(one, 20);
  run(restored, 20);
  EXPECT_EQ(one.state_hash(), restored.state_hash());
}

}  // namespace
}  // namespace prosector::test
