#include <gtest/gtest.h>

#include "server/physics/mechanics/soft/soft_body.h"
#include "tests/physics/scenes.h"

namespace prosector::test {
namespace {

SceneDesc block_on_table() {
  SceneDesc scene;
  scene.rigid = {table()};
  scene.soft = {block()};
  return scene;
}

// The palm's lower side above the middle of the block, `clear` metres over its top.
Vec3 palm_over(double clear) {
  return {-0.004, 0.06 + 0.011 + clear, 0.045};
}

double height(const Simulation& simulation, BodyId body) {
  return simulation.soft_state(body).motion.x(Eigen::seq(1, Eigen::last, Eigen::fix<3>)).mean();
}

TEST(Soft, RestsOnTheTableAsleepFromTheStart) {
  Simulation simulation(block_on_table(), options());
  EXPECT_TRUE(simulation.asleep(1));
  for (int i = 0; i < 60; ++i) {
    const StepReport& report = simulation.step({});
    EXPECT_EQ(report.contacts, 0U);
    EXPECT_TRUE(report.bodies.empty());
  }
  EXPECT_EQ(simulation.max_displacement(1), 0);
}

TEST(Soft, HandPressesAndTheBlockComesBackAndSleeps) {
  SceneDesc scene = block_on_table();
  scene.soft[0].attach = {{{0, 0, 0}, 0.04, 2e7}};  // or the hand would drag it along the table
  scene.rigid[0].contact.friction = 0;              // dry friction may hold a part of the strain
  Simulation simulation(scene, options());
  simulation.step(appear(palm_over(0.03)));
  EXPECT_TRUE(simulation.asleep(1));
  double deepest = 0;
  for (int i = 0; i < 90; ++i) {
    simulation.step(target(palm_over(0.03 - 0.05 * std::min(1.0, i / 60.0))));
    deepest = std::max(deepest, simulation.max_displacement(1));
  }
  EXPECT_FALSE(simulation.asleep(1));
  EXPECT_GT(deepest, 0.010);
  ASSERT_EQ(simulation.hands().size(), 1U);
  EXPECT_TRUE(simulation.hands()[0].contact.touching);
  EXPECT_EQ(simulation.hands()[0].contact.body, 1U);
  EXPECT_GT(simulation.hands()[0].contact.normal.y(), 0.5);
  EXPECT_LT(simulation.hands()[0].contact.impulse * 60, 41);
  run(simulation, 300, target(palm_over(0.15)));
  EXPECT_LT(simulation.max_displacement(1), 1e-3);
  EXPECT_TRUE(simulation.asleep(1));
}

/// What sleeps keeps its energy in the report: waking and falling asleep are no events there.
TEST(Soft, EnergyGoesOnOverSleepAndWaking) {
  Simulation simulation(block_on_table(), options());
  const auto energy = [](const StepReport& r) {
    return r.kinetic_energy + r.elastic_energy + r.potential_energy;
  };
  double before = energy(simulation.step(appear(palm_over(0.03))));
  EXPECT_TRUE(simulation.asleep(1));
  EXPECT_NEAR(before, 0.18, 0.03) << "the block's weight half its height up";
  int woken = 0, slept = 0;
  for (int i = 0; i < 400; ++i) {
    const bool slept_before = simulation.asleep(1);
    if (i == 200) simulation.restore(simulation.checkpoint());
    const double now = energy(simulation.step(target(palm_over(i < 60 ? 0.03 - 0.0005 * i : 0.1))));
    if (simulation.asleep(1) != slept_before) {
      EXPECT_NEAR(now, before, 1e-4) << i;
      ++(slept_before ? woken : slept);
    } else if (slept_before) {
      EXPECT_NEAR(now, before, 1e-9) << i;
    }
    before = now;
  }
  EXPECT_EQ(woken, 1);
  EXPECT_EQ(slept, 1);
}

/// Long held and let go, tissue creeps back, at the end more slowly than what counts as rest: it must neither
/// fall asleep in a shape that it would leave, nor be taken for stuck there and unfolded.
TEST(Soft, SleepsOnlyWhenItsStressHasRelaxed) {
  SceneDesc scene = block_on_table();
  scene.soft[0].attach = {{{0, 0, 0}, 0.04, 2e7}};
  scene.soft[0].material.relaxation = {{0.5, 3}};
  scene.rigid[0].contact.friction = 0;
  Simulation simulation(scene, options());
  const double rest = height(simulation, 1);
  simulation.step(appear(palm_over(0.02)));
  run(simulation, 600, target(palm_over(-0.012)));
  run(simulation, 30, target(palm_over(0.05)));
  const double begun = height(simulation, 1);
  EXPECT_LT(begun, rest - 2e-4) << "it is still pressed in";
  int awake = 0;
  for (; !simulation.asleep(1) && awake < 60 * 60; ++awake)
    for (const BodyReport& body : simulation.step(target(palm_over(0.05))).bodies) EXPECT_FALSE(body.reset);
  EXPECT_TRUE(simulation.asleep(1));
  EXPECT_GT(awake, 6 * 60) << "creep takes τ/(1 − g)";
  EXPECT_NEAR(height(simulation, 1), rest, 2e-5);
}

TEST(Soft, BallRestsOnTheBlockAtManyMassRatios) {
  for (const double density : {10.0, 1000.0, 20000.0}) {
    SceneDesc scene = block_on_table();
    scene.rigid.push_back(part_body("ball", "sphere", {0.04, 0, 0}, {0, 0.085, 0}, density));
    Simulation simulation(scene, options());
    run(simulation, 400);
    const RigidBodyState ball = simulation.rigid_state(1);
    ASSERT_TRUE(is_finite(ball.pose)) << density;
    EXPECT_LT(ball.linear_velocity.norm(), 0.01) << density;
    EXPECT_GT(ball.pose.p.y(), 0.015) << density;
    EXPECT_LT(ball.pose.p.y(), 0.082) << density;
  }
}

TEST(Soft, BoxOnBoxOnBlockIsOneIsland) {
  SceneDesc scene = block_on_table();
  scene.rigid.push_back(part_body("lower", "box", {0.06, 0.02, 0.06}, {0, 0.0705, 0}, 700));
  scene.rigid.push_back(part_body("upper", "box", {0.04, 0.02, 0.04}, {0, 0.0908, 0}, 700));
  Simulation simulation(scene, options());
  run(simulation, 20);
  const StepReport& report = simulation.step({});
  EXPECT_EQ(report.mixed_islands, 1U);
  run(simulation, 500);
  EXPECT_NEAR(simulation.rigid_state(2).pose.p.y() - simulation.rigid_state(1).pose.p.y(), 0.02, 1e-3);
  EXPECT_TRUE(simulation.asleep(1) && simulation.asleep(2) && simulation.asleep(3));
}

TEST(Soft, MomentumIsExchangedEqualAndOpposite) {
  SceneDesc scene;
  scene.gravity.setZero();
  scene.soft = {block()};
  scene.soft[0].material.damping_mass = 0;
  scene.soft[0].configuration.solver_tolerance = 1e-8;
  scene.soft[0].configuration.newton_iterations = 30;
  scene.soft[0].configuration.solver_iterations = 400;
  scene.rigid = {part_body("ball", "sphere", {0.04, 0, 0}, {0, 0.5, 0}, 3000)};
  scene.gravity = {0, -1, 0};
  scene.soft[0].gravity = false;
  Simulation simulation(scene, options());
  const double mass = 3000 * 4.0 / 3 * 3.14159265358979 * 8e-6;
  double before = 0;
  bool met = false;
  for (int i = 0; i < 90; ++i) {
    simulation.step({});
    const soft::SoftBody& body = simulation.soft(1);
    double momentum = mass * simulation.rigid_state(0).linear_velocity.y();
    for (Eigen::Index n = 0; n < body.nodes(); ++n)
      momentum += body.node_mass()[n] * simulation.soft_state(1).motion.v[3 * n + 1];
    met = met || !simulation.asleep(1);
    EXPECT_NEAR(momentum - before, -mass / 60, 2e-5) << i;
    before = momentum;
  }
  EXPECT_TRUE(met);
}

TEST(Soft, EquilibriumSagsALittle) {
  Simulation simulation(block_on_table(), options());
  EXPECT_GT(height(simulation, 1), 0.02);
  EXPECT_LT(height(simulation, 1), 0.0299);
}

}  // namespace
}  // namespace prosector::test
