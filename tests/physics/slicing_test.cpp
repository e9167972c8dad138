// A blade drawn along its edge needs less force to go on: Atkins, Xu and Jeronimidis (2004).

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/physics/scalpel.h"

namespace prosector::test {
namespace {

constexpr double toughness = 10, height = 0.06;  // J/m², m

struct Forces {
  double push = 0, draw = 0;  // N, mean
  double work = 0, way = 0;   // J that the hand did, m that the blade went across its edge
};

constexpr double long_edge = 0.46;  // m

/// The hand pushes a blade through what there is and draws it along its edge, `ratio` times as fast.
Forces slice(const SceneDesc& scene, double ratio) {
  Simulation simulation(scene, options());
  Vec3 at = take(simulation);
  Forces out;
  int ticks = 0;
  Vec3 before = simulation.rigid_state(scalpel).pose.p;
  for (int i = 0; i < 160; ++i) {
    const bool near = at.x() > -0.055;
    at += 0.0008 * Vec3(1, near ? ratio : 0, 0);
    simulation.step(target(at));
    const Vec3 force = simulation.hands()[0].contact.force, now = simulation.rigid_state(scalpel).pose.p;
    if (now.x() > -0.02 && now.x() < 0.02) {
      out.push += force.x();
      out.draw += force.y();
      out.work += force.dot(now - before);
      out.way += now.x() - before.x();
      ++ticks;
    }
    before = now;
  }
  out.push /= ticks;
  out.draw /= ticks;
  return out;
}

class Slicing : public testing::TestWithParam<double> {};

TEST_P(Slicing, PushesWithAsMuchLessForceAsTheClosedFormSays) {
  const double ratio = GetParam(), alone = toughness * height;
  SceneDesc scene = block_and_scalpel();
  scene.rigid[0].edges = {{{0, -0.04, 0}, {0, -0.04 - long_edge, 0}}};
  scene.soft[0].material.toughness = toughness;
  scene.soft[0].material.youngs_modulus = 2e4;
  const Forces forces = slice(scene, ratio);
  const double push = alone / (1 + ratio * ratio);
  RecordProperty("measured", std::to_string(forces.push) + " N, " + std::to_string(forces.draw) + " N, " +
                                 std::to_string(forces.work / (alone * forces.way)) + " of the work");
  EXPECT_NEAR(forces.push, push, 0.1 * push);
  EXPECT_NEAR(forces.draw, ratio * push, 0.1 * std::hypot(push, ratio * push));
  EXPECT_NEAR(forces.work, alone * forces.way, 0.1 * alone * forces.way);
}

constexpr double sheet_toughness = 20;  // J/m²: of what hardly gives

SceneDesc membrane_to_slice() {
  SceneDesc scene = membrane_and_scalpel();
  scene.rigid[0].edges = {{{0, -0.04, 0}, {0, -0.04 - long_edge, 0}}};
  scene.soft[0].material.toughness = sheet_toughness;
  scene.soft[0].material.youngs_modulus = 5e6;
  return scene;
}

TEST_P(Slicing, PushesThroughASheetWithAsMuchLess) {
  const double ratio = GetParam();
  const SceneDesc scene = membrane_to_slice();
  const double alone = sheet_toughness * scene.soft[0].geometry.size.y(), push = alone / (1 + ratio * ratio);
  const Forces forces = slice(scene, ratio);
  RecordProperty("measured", std::to_string(forces.push / push) + ", " + std::to_string(forces.draw / push) +
                                 " of the push, " + std::to_string(forces.work / (alone * forces.way)) +
                                 " of the work");
  EXPECT_NEAR(forces.push, push, 0.1 * push);
  EXPECT_NEAR(forces.draw, ratio * push, 0.1 * std::hypot(push, ratio * push));
  EXPECT_NEAR(forces.work, alone * forces.way, 0.1 * alone * forces.way);
}

// A blade that leans goes the same way in the sheet.
TEST(SlicingSheets, LeaningDoesNotSlice) {
  SceneDesc scene = membrane_to_slice();
  const Vec3 top(-0.04, -0.04, 0);  // so far ahead that it goes through the sheet below the handle
  scene.rigid[0].edges = {{top, top + Vec3(0.2, -0.2, 0)}};
  const double alone = sheet_toughness * scene.soft[0].geometry.size.y();
  const Forces forces = slice(scene, 0);
  RecordProperty("measured", std::to_string(forces.push / alone));
  EXPECT_NEAR(forces.push, alone, 0.05 * alone);
}

INSTANTIATE_TEST_SUITE_P(Ratio, Slicing, testing::Values(0.0, 1.0, 3.0));

}  // namespace
}  // namespace prosector::test
