// Soft bodies against each other.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "server/physics/mechanics/soft/soft_body.h"
#include "tests/physics/scenes.h"
#include "tests/physics/thrown.h"
#include "tests/play/judge.h"

namespace prosector::test {
namespace {

// Two blocks of the same tissue, the upper one let fall on the lower one, turned so that no vertex meets
// another.
SceneDesc tower() {
  SceneDesc scene;
  scene.rigid = {table()};
  scene.soft = {block("lower"), block("upper")};
  scene.soft[1].pose.p.y() = 0.115;
  scene.soft[1].pose.q = Quat(Eigen::AngleAxisd(0.3, Vec3::UnitY()));
  return scene;
}

TEST(SoftPairs, BlockRestsOnABlock) {
  const SceneDesc scene = tower();
  Simulation simulation(scene, options());
  EXPECT_TRUE(simulation.asleep(1));
  EXPECT_FALSE(simulation.asleep(2)) << "it falls";
  run(simulation, 20);
  EXPECT_FALSE(simulation.asleep(1)) << "it was hit";
  run(simulation, 280);
  const Vec3 before = centre(simulation, 2);
  run(simulation, 60);
  EXPECT_LT((centre(simulation, 2) - before).norm(), 1e-4);
  EXPECT_NEAR(before.x(), 0, 2e-3);
  // The tolerance that a scene states, as for rigid bodies on tissue; edges carry more than the middle.
  const SoftDesc& soft = scene.soft[0];
  const double pressure = soft.material.density * 9.81 * soft.geometry.size.y();
  const double yields =
      pressure / soft.material.youngs_modulus * soft.geometry.surface_cell / scene.contact_stiffness;
  EXPECT_LT(overlap(simulation, 1, 2), 3 * yields + 1e-5);
  run(simulation, 600);
  EXPECT_EQ(simulation.asleep(1), simulation.asleep(2)) << "an island sleeps whole";
}

TEST(SoftPairs, BlocksThatBearEachOtherStartInTheirEquilibrium) {
  SceneDesc scene = tower();
  scene.soft[1].pose.p.y() = 0.091;
  Simulation simulation(scene, options());
  EXPECT_TRUE(simulation.asleep(1) && simulation.asleep(2));
  EXPECT_LT(centre(simulation, 1).y(), 0.0295) << "the upper one's weight is on it";
  EXPECT_LT(overlap(simulation, 1, 2), 1e-3);
}

/// A floating body, and one on which alone gravity acts, that falls against it.
SceneDesc falling(const std::string& shape, const Vec3& size) {
  SceneDesc scene;
  for (const char* name : {"floating", "falling"}) {
    SoftDesc& soft = scene.soft.emplace_back();
    soft.name = name;
    soft.geometry.shape = shape;
    soft.geometry.size = size;
    soft.geometry.cell = soft.geometry.surface_cell = 0.03;
    soft.material.damping_mass = 0;
  }
  scene.soft[0].gravity = false;
  return scene;
}

TEST(SoftPairs, BallsExchangeMomentumAndGainNoEnergy) {
  SceneDesc scene = falling("ball", {0.1, 0.1, 0.1});
  scene.gravity = {-2, 0, 0};
  scene.soft[1].pose.p = {0.2, 0.02, 0.01};
  for (SoftDesc& soft : scene.soft) {
    soft.configuration.newton_iterations = 30;
    soft.configuration.solver_iterations = 400;
    soft.configuration.solver_tolerance = 1e-8;
  }
  Simulation simulation(scene, options());
  const double mass = simulation.soft(1).total_mass();
  double start = 0, highest = 0, deepest = 0;
  for (int tick = 1; tick <= 60; ++tick) {
    const double now = energy(simulation.step({}));
    if (tick == 1) start = now;
    highest = std::max(highest, now - start);
    deepest = std::max(deepest, overlap(simulation, 0, 1));
    const Vec3 taken = momentum(simulation, 0), kept = momentum(simulation, 1);
    EXPECT_LT((taken + kept - mass * tick / 60 * scene.gravity).norm(), 1e-3 * std::max(taken.norm(), 0.01))
        << tick;
  }
  EXPECT_LT(momentum(simulation, 0).x(), -0.2 * mass) << "it was hit";
  EXPECT_LT(highest, 1e-3 * mass * 0.2);
  EXPECT_LT(deepest, 2e-3);
}

// The one is held, the other falls on it at 5 m/s, off its middle, and past it.
TEST(SoftPairs, LiversThrownAtEachOtherSeparateAndRecover) {
  SceneDesc scene = falling("liver", {0.2, 0.1, 0.15});
  scene.gravity = {0, -25, 0};
  scene.soft[0].attach = {{.center = Vec3::Zero(), .radius = 0.04, .stiffness = 2e7}};
  scene.soft[0].material.damping_mass = 3;  // or it would swing on
  scene.soft[1].pose.p = {0.1, 0.6, 0.02};
  Simulation simulation(scene, options());
  double hit = 0;
  for (int tick = 0; tick < 150; ++tick) {
    simulation.step({});
    for (const BodyId body : {0u, 1u}) ASSERT_TRUE(simulation.soft_state(body).motion.x.allFinite()) << tick;
    hit = std::max(hit, simulation.max_displacement(0));
  }
  EXPECT_GT(hit, 0.01);
  EXPECT_LT(centre(simulation, 1).y(), -1) << "it has left";
  for (const BodyId body : {0u, 1u}) EXPECT_LT(distortion(simulation, body), 2e-3) << body;
}

TEST(SoftPairs, SameHashForAnyThreadCountAndAfterRestore) {
  const SceneDesc scene = tower();
  Simulation one(scene, options(1)), two(scene, options(2)), restored(scene, options(1));
  run(one, 40);
  run(two, 40);
  EXPECT_EQ(one.state_hash(), two.state_hash());
  restored.restore(one.checkpoint());
  run(one, 40);
  run(restored, 40);
  EXPECT_EQ(one.state_hash(), restored.state_hash());
}

TEST(SoftPairs, ObeyMasks) {
  SceneDesc scene = tower();
  scene.soft[1].contact.group = "ghosts";
  scene.soft[1].contact.touches = {"ghosts"};
  Simulation simulation(scene, options());
  run(simulation, 60);
  EXPECT_LT(centre(simulation, 2).y(), -1);
}

}  // namespace
}  // namespace prosector::test
