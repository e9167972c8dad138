#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "server/physics/mechanics/soft/soft_body.h"
#include "tests/physics/scenes.h"

namespace prosector::test {
namespace {

SceneDesc bench() {
  SceneDesc scene;
  scene.rigid = {table(), part_body("probe", "capsule", {0.012, 0.2, 0}, {0, 0.006, 0})};
  scene.rigid[1].pose.q = Quat(Eigen::AngleAxisd(1.5707963267948966, Vec3::UnitZ()));
  return scene;
}

TEST(Hand, FollowsItsTargetWithoutLag) {
  SceneDesc scene;
  Simulation simulation(scene, options());
  simulation.step(appear({0, 1, 0}));
  for (int i = 1; i <= 60; ++i) simulation.step(target({0.01 * i, 1, 0}));
  EXPECT_NEAR(simulation.hands()[0].pose.p.x(), 0.6, 0.004);
}

// Largest change of the distance between two nodes: deformation without rigid motion.
double deformation(const VecX& before, const VecX& after) {
  double worst = 0;
  for (Eigen::Index i = 0; i < before.size(); i += 3)
    for (Eigen::Index j = 0; j < i; j += 3)
      worst = std::max(worst, std::abs((before.segment<3>(i) - before.segment<3>(j)).norm() -
                                       (after.segment<3>(i) - after.segment<3>(j)).norm()));
  return worst;
}

double mean_height(const VecX& x) {
  return x(Eigen::seq(1, Eigen::last, Eigen::fix<3>)).mean();
}

/// A hand whose target jumps by 1.4 m through a block, to and fro, for two seconds, and then leaves. How far
/// the hand went while it touched something, m.
double teleport(Simulation& simulation, BodyId block) {
  double dragged = 0;
  simulation.step(appear({0, 0.1, 0.05}));
  for (int i = 0; i < 120; ++i) {
    const double side = i / 20 % 2 == 0 ? 1 : -1;
    const Vec3 before = simulation.hands()[0].pose.p;
    simulation.step(target({side * 0.5, 0.02, side * 0.5}));
    const HandState& hand = simulation.hands()[0];
    EXPECT_TRUE(is_finite(hand.pose)) << i;
    EXPECT_LT(hand.pose.p.norm(), 3) << i;
    EXPECT_TRUE(simulation.soft_state(block).motion.x.allFinite()) << i;
    if (hand.contact.touching) dragged += (hand.pose.p - before).norm();
  }
  run(simulation, 400, target({1, 1, 1}));
  return dragged;
}

// On a dry table a free block may be shoved, and friction may hold a part of its strain (2.9 mm here: what
// remains of them is 0.07 mm once friction is taken away). It may go no farther than the hand took it.
TEST(Hand, TeleportStaysBounded) {
  SceneDesc scene;
  scene.rigid = {table()};
  scene.soft = {block()};
  Simulation simulation(scene, options());
  const VecX settled = simulation.soft_state(1).motion.x;
  const double dragged = teleport(simulation, 1);
  EXPECT_TRUE(simulation.asleep(1));
  EXPECT_LT(simulation.max_displacement(1), dragged);
  EXPECT_NEAR(mean_height(simulation.soft_state(1).motion.x), mean_height(settled), 5e-4);
  // Friction holds at most μ·m·g/2 across the middle, at the base: a strain of 4·that/(E·section) there, and
  // none at the ends.
  const SoftDesc& desc = scene.soft[0];
  const double friction = std::sqrt(desc.contact.friction * scene.rigid[0].contact.friction);
  const double held = friction * desc.material.density * desc.geometry.size.prod() * 9.81 / 2;
  const double strain =
      4 * held / (desc.material.youngs_modulus * desc.geometry.size.x() * desc.geometry.size.y());
  EXPECT_LT(deformation(settled, simulation.soft_state(1).motion.x), strain * desc.geometry.size.x() / 2);
}

// On a frictionless table nothing can hold a strain: the shape is back.
TEST(Hand, ShapeRecoversFromTeleports) {
  SceneDesc scene;
  scene.rigid = {table()};
  scene.rigid[0].contact.friction = 0;
  scene.soft = {block()};
  scene.soft[0].attach = {{{0, 0, 0}, 0.04, 2e7}};  // or it would leave the table
  Simulation simulation(scene, options());
  teleport(simulation, 1);
  EXPECT_LT(simulation.max_displacement(1), 0.001);
}

TEST(Hand, ImpossibleTargetsAreIgnored) {
  SceneDesc scene;
  Simulation simulation(scene, options());
  simulation.step(appear({0, 1, 0}));
  run(simulation, 30, target({std::numeric_limits<double>::quiet_NaN(), 1, 0}));
  run(simulation, 30, target({1e9, 1, 0}));
  EXPECT_NEAR(simulation.hands()[0].pose.p.y(), 1, 1e-6);
  EXPECT_NEAR(simulation.hands()[0].pose.p.x(), 0, 1e-6);
}

TEST(Hand, StopsAtTheTable) {
  SceneDesc scene;
  scene.rigid = {table()};
  Simulation simulation(scene, options());
  simulation.step(appear({0, 0.1, 0}));
  run(simulation, 240, target({0, -0.5, 0}));
  EXPECT_GT(simulation.hands()[0].pose.p.y(), 0.009);
  EXPECT_LT(simulation.hands()[0].contact.impulse * 60, 60);
}

TEST(Hand, LiftsAndDropsTheProbe) {
  Simulation simulation(bench(), options());
  run(simulation, 30);
  simulation.step(appear({0, 0.04, 0.045}));
  simulation.step(event(HandEvent::Kind::grasp, {0, 0.04, 0.045}));
  ASSERT_TRUE(simulation.hands()[0].holding);
  EXPECT_EQ(*simulation.hands()[0].holding, 1U);
  for (int i = 0; i < 120; ++i) simulation.step(target({0, 0.04 + 0.3 * std::min(1.0, i / 60.0), 0.045}));
  EXPECT_GT(simulation.rigid_state(1).pose.p.y(), 0.28);
  simulation.step(event(HandEvent::Kind::release, {0, 0.34, 0.045}));
  EXPECT_FALSE(simulation.hands()[0].holding);
  run(simulation, 120, target({0, 0.34, 0.045}));
  EXPECT_LT(simulation.rigid_state(1).pose.p.y(), 0.05);
}

TEST(Hand, HoldsTissueAndLetsGo) {
  SceneDesc scene;
  scene.rigid = {table()};
  scene.soft = {block()};
  Simulation simulation(scene, options());
  const Vec3 on_top(-0.004, 0.06 + 0.013, 0.045);
  simulation.step(appear(on_top));
  simulation.step(event(HandEvent::Kind::grasp, on_top));
  ASSERT_TRUE(simulation.hands()[0].holding);
  EXPECT_EQ(*simulation.hands()[0].holding, 1U);
  for (int i = 0; i < 60; ++i) simulation.step(target(on_top + Vec3(0, 0.0005 * i, 0)));
  EXPECT_GT(simulation.max_displacement(1), 0.005);
  simulation.step(event(HandEvent::Kind::vanish, on_top));
  EXPECT_TRUE(simulation.hands().empty());
  run(simulation, 300);
  EXPECT_TRUE(simulation.asleep(1));
}

TEST(Hand, TakesWhatIsWantedWhereItReachesThatAndElseTheNearest) {
  SceneDesc scene = bench();
  scene.rigid.push_back(scene.rigid[1]);
  scene.rigid[2].name = "beside";
  scene.rigid[2].pose.p.z() -= 0.02;
  scene.rigid.push_back(scene.rigid[1]);
  scene.rigid[3].name = "far";
  scene.rigid[3].pose.p.z() -= 0.5;
  const auto taken = [&](HandEvent::Kind kind, BodyId wanted) {
    const Vec3 over_them(0, 0.04, 0.045);
    Simulation simulation(scene, options());
    run(simulation, 30);
    simulation.step(appear(over_them));
    TickInput input = event(kind, over_them);
    input.events.back().body = wanted;
    simulation.step(input);
    return simulation.hands()[0].holding;
  };
  const auto nearest = taken(HandEvent::Kind::grasp, 0);
  ASSERT_TRUE(nearest);
  for (const BodyId wanted : {1U, 2U}) EXPECT_EQ(taken(HandEvent::Kind::grasp_body, wanted), wanted);
  for (const BodyId wanted : {0U, 3U, 99U}) EXPECT_EQ(taken(HandEvent::Kind::grasp_body, wanted), nearest);
  for (const BodyId wanted : {1U, 2U}) EXPECT_EQ(taken(HandEvent::Kind::regrasp, wanted), wanted);
  for (const BodyId wanted : {0U, 3U, 99U}) EXPECT_FALSE(taken(HandEvent::Kind::regrasp, wanted)) << wanted;
}

TEST(Hand, ResetPutsBodiesBack) {
  SceneDesc scene = bench();
  scene.rigid[1].pose.p.y() = 0.5;
  Simulation simulation(scene, options());
  run(simulation, 60);
  TickInput input;
  input.events.push_back({HandEvent::Kind::reset_body, 0, 0, 1});
  input.events.push_back({HandEvent::Kind::reset_body, 0, 0, 99});
  simulation.step(input);
  EXPECT_NEAR(simulation.rigid_state(1).pose.p.y(), 0.5, 0.01);
}

}  // namespace
}  // namespace prosector::test
