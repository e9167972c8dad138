// Soft bodies at all fidelities: what they rest on, what they exchange.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "server/physics/mechanics/soft/soft_body.h"
#include "tests/physics/scenes.h"

namespace prosector::test {
namespace {

Vec3 centre(const Simulation& simulation, BodyId body) {
  return simulation.soft_state(body).motion.x.reshaped(3, simulation.soft(body).nodes()).rowwise().mean();
}

/// Linear and, about the origin, angular momentum.
std::pair<Vec3, Vec3> momentum(const Simulation& simulation, BodyId body) {
  const soft::SoftBody& soft = simulation.soft(body);
  const soft::Motion& motion = simulation.soft_state(body).motion;
  std::pair<Vec3, Vec3> sum{Vec3::Zero(), Vec3::Zero()};
  for (Eigen::Index i = 0; i < soft.nodes(); ++i) {
    const Vec3 p = soft.node_mass()[i] * motion.v.segment<3>(3 * i);
    sum.first += p;
    sum.second += motion.x.segment<3>(3 * i).cross(p);
  }
  return sum;
}

bool is_rough(Fidelity fidelity) {
  return fidelity != Fidelity::none && fidelity != Fidelity::mesh;
}

class SoftFidelity : public testing::TestWithParam<Fidelity> {
 protected:
  Fidelity fidelity() const { return GetParam(); }
};
INSTANTIATE_TEST_SUITE_P(All, SoftFidelity,
                         testing::Values(Fidelity::none, Fidelity::sphere, Fidelity::aabb, Fidelity::obb,
                                         Fidelity::hull, Fidelity::mesh),
                         [](const auto& info) { return std::string(fidelity_name(info.param)); });

TEST_P(SoftFidelity, RestsOnTheTable) {
  SceneDesc scene;
  scene.rigid = {table()};
  scene.soft = {block()};
  scene.soft[0].contact.collision = fidelity();
  scene.soft[0].pose.p.y() += 0.05;
  Simulation simulation(scene, options());
  run(simulation, 240);
  ASSERT_TRUE(simulation.soft_state(1).motion.x.allFinite());
  const double height = centre(simulation, 1).y();
  if (fidelity() == Fidelity::none) {
    EXPECT_LT(height, -10);
    return;
  }
  const Vec3 half = scene.soft[0].geometry.size / 2;
  EXPECT_NEAR(height, fidelity() == Fidelity::sphere ? half.norm() : half.y(), 3e-3);
  if (fidelity() != Fidelity::sphere) {
    EXPECT_LT(std::hypot(centre(simulation, 1).x(), centre(simulation, 1).z()), 1e-2) << "it rolls";
  }
  EXPECT_LT(momentum(simulation, 1).first.norm() / simulation.soft(1).total_mass(), 2e-3) << "m/s";
}

// A rigid ball falls on the corner of a floating block.
TEST_P(SoftFidelity, ExchangesMomentumWithARigidBall) {
  SceneDesc scene;
  scene.rigid = {part_body("ball", "sphere", {0.05, 0, 0}, {0.03, 0.1, 0.02}, 800)};
  scene.soft = {block()};
  scene.soft[0].contact.collision = fidelity();
  scene.soft[0].gravity = false;
  scene.soft[0].material.damping_mass = 0;
  scene.soft[0].configuration.newton_iterations = 30;
  scene.soft[0].configuration.solver_iterations = 400;
  scene.soft[0].configuration.solver_tolerance = 1e-8;
  Simulation simulation(scene, options());
  const double mass = 800 * 4. / 3 * M_PI * std::pow(0.025, 3);
  double start = 0, highest = 0;
  for (int tick = 1; tick <= 40; ++tick) {
    const double now = energy(simulation.step({}));
    if (tick == 1) start = now;
    highest = std::max(highest, now - start);
    const auto [linear, angular] = momentum(simulation, 1);
    const RigidBodyState ball = simulation.rigid_state(0);
    const Vec3 given = mass * (tick / 60. * scene.gravity - ball.linear_velocity);
    EXPECT_LT((linear - given).norm(), 1e-3 * std::max(linear.norm(), 0.01)) << tick;
  }
  EXPECT_EQ(momentum(simulation, 1).first.norm() > 0.01, fidelity() != Fidelity::none);
  EXPECT_LT(highest, 1e-3 * mass * 9.81 * 0.1) << "J gained";
}

// Along the ball's way the moment about its line is what gravity, which acts on it, can't give.
TEST_P(SoftFidelity, ExchangesAngularMomentum) {
  SceneDesc scene = {};
  scene.gravity = Vec3::Zero();
  scene.soft = {block("first"), block("second")};
  scene.soft[1].pose.p += Vec3(0.04, 0.058, 0.03);  // a little in each other: they part
  for (SoftDesc& soft : scene.soft) {
    soft.contact.collision = fidelity();
    soft.contact.rolling_resistance =
        0;  // the pair of its forces turns with the bodies within a tick: 2 % of l
    soft.material.damping_mass = 0;
    soft.material.damping_stiffness = 0;
    soft.configuration.newton_iterations = 30;
    soft.configuration.solver_iterations = 400;
    soft.configuration.solver_tolerance = 1e-9;
  }
  scene.gravity = {0, -1e-6, 0};  // so that they are awake
  Simulation simulation(scene, options());
  run(simulation, 30);
  const auto [p, l] = momentum(simulation, 0);
  const auto [q, m] = momentum(simulation, 1);
  EXPECT_EQ(p.norm() > 1e-3, fidelity() != Fidelity::none);
  EXPECT_LT((p + q).norm(), 1e-3 * std::max(p.norm(), 1e-3));
  EXPECT_LT((l + m).norm(), 1e-2 * std::max(l.norm(), 1e-3));
}

TEST_P(SoftFidelity, BearsAnother) {
  if (fidelity() == Fidelity::none) return;
  for (const Fidelity upper : {Fidelity::obb, Fidelity::hull, Fidelity::mesh}) {
    SceneDesc scene;
    scene.rigid = {table()};
    scene.soft = {block("lower"), block("upper")};
    scene.soft[1].geometry.size = {0.07, 0.06, 0.07};
    scene.soft[1].pose.p.y() = 0.105;
    scene.soft[1].pose.q = Quat(Eigen::AngleAxisd(0.3, Vec3::UnitY()));
    scene.soft[0].contact.collision = fidelity();
    scene.soft[1].contact.collision = upper;
    Simulation simulation(scene, options());
    run(simulation, 60);
    for (const BodyId body : {1u, 2u})
      ASSERT_TRUE(simulation.soft_state(body).motion.x.allFinite()) << fidelity_name(upper);
    if (fidelity() == Fidelity::sphere) continue;  // which it rolls off
    EXPECT_GT(centre(simulation, 2).y() - centre(simulation, 1).y(), 0.04) << fidelity_name(upper);
    EXPECT_GT(centre(simulation, 1).y(), 0.02) << fidelity_name(upper);
  }
}

TEST_P(SoftFidelity, SameHashForAnyThreadCountAndAfterRestore) {
  SceneDesc scene;
  scene.rigid = {table(), part_body("plate", "box", {0.08, 0.02, 0.04}, {0, 0.12, 0}, 300)};
  scene.soft = {block()};
  scene.soft[0].contact.collision = fidelity();
  Simulation one(scene, options(1)), two(scene, options(2)), restored(scene, options(1));
  run(one, 25);
  run(two, 25);
  EXPECT_EQ(one.state_hash(), two.state_hash());
  restored.restore(one.checkpoint());
  run(one, 15);
  run(restored, 15);
  EXPECT_EQ(one.state_hash(), restored.state_hash());
}

TEST_P(SoftFidelity, RoughOnesAskFewerContactsOfTheSolver) {
  if (!is_rough(fidelity())) return;
  std::uint32_t contacts[2];
  for (const bool rough : {false, true}) {
    SceneDesc scene;
    scene.rigid = {table()};
    scene.soft = {block()};
    if (rough) scene.soft[0].contact.collision = fidelity();
    scene.soft[0].geometry.cell = scene.soft[0].geometry.surface_cell = 0.01;
    scene.soft[0].pose.p.y() += 0.08;
    Simulation simulation(scene, options());
    contacts[rough] = 0;
    for (int tick = 0; tick < 30; ++tick)
      contacts[rough] = std::max(contacts[rough], simulation.step({}).contacts);
  }
  EXPECT_GT(contacts[1], 0u);
  EXPECT_LT(contacts[1], contacts[0]);
}

}  // namespace
}  // namespace prosector::test
