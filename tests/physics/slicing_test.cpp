// A blade drawn along its edge needs less force to go on: Atkins, Xu and Jeronimidis (2004).

#include <gtest/gtest.h>

#include <cmath>

#include "tests/physics/scalpel.h"

namespace prosector::test {
namespace {

constexpr double toughness = 10, height = 0.06;  // J/m², m

struct Forces {
  double push = 0, draw = 0;  // N, mean
  double work = 0, way = 0;   // J that the hand did, m that the blade went across its edge
};

/// The hand pushes a long blade through the block and draws it along its edge, `ratio` times as fast.
Forces slice(double ratio) {
  SceneDesc scene = block_and_scalpel();
  scene.rigid[0].edges = {{{0, -0.04, 0}, {0, -0.5, 0}}};
  scene.soft[0].toughness = toughness;
  scene.soft[0].youngs_modulus = 2e4;
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
  const Forces forces = slice(ratio);
  const double push = alone / (1 + ratio * ratio);
  RecordProperty("measured", std::to_string(forces.push) + " N, " + std::to_string(forces.draw) + " N, " +
                                 std::to_string(forces.work / (alone * forces.way)) + " of the work");
  EXPECT_NEAR(forces.push, push, 0.1 * push);
  EXPECT_NEAR(forces.draw, ratio * push, 0.1 * std::hypot(push, ratio * push));
  EXPECT_NEAR(forces.work, alone * forces.way, 0.1 * alone * forces.way);
}

INSTANTIATE_TEST_SUITE_P(Ratio, Slicing, testing::Values(0.0, 1.0, 3.0));

}  // namespace
}  // namespace prosector::test
