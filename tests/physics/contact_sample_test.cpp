// What a hand is told of what it touches and of what it comes near: each figure against a closed form.

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "server/physics/mechanics/soft/soft_body.h"
#include "tests/physics/scenes.h"

namespace prosector::test {
namespace {

constexpr double ball_radius = 0.05;
const Vec3 ball_centre(0.1, -0.05, 0.2);
/// From the wrist to where the palm's middle is over the ball.
const Vec3 over_ball = ball_centre + Vec3(-0.004, 0, 0.045);

/// A ball that stands fast, turned and beside the origin, so that frames can be told apart.
SceneDesc over_a_fixed_ball() {
  SceneDesc scene;
  scene.gravity.setZero();
  scene.rigid = {part_body("ball", "sphere", {2 * ball_radius, 0, 0}, ball_centre)};
  scene.rigid[0].fixed = true;
  scene.rigid[0].pose.q = Quat(Eigen::AngleAxisd(2.0, Vec3(1, 2, 3).normalized()));
  return scene;
}

// The coupling's force is bounded: pulled to where it cannot get, the hand presses with all of it, and
// friction takes the part that is aside.
TEST(ContactSample, APressedBallTellsWhatPressesWhereAndHowDeep) {
  const SceneDesc scene = over_a_fixed_ball();
  Simulation simulation(scene, options());
  simulation.step(appear(over_ball + Vec3(0, 0.08, 0)));
  const Vec3 pull = Vec3(0.2, -1, 0.1).normalized();
  run(simulation, 60, target(over_ball - Vec3(0, 0.2, 0)));
  run(simulation, 60, target(simulation.hands()[0].pose.p + pull));
  const HandState& hand = simulation.hands()[0];
  const ContactSample& sample = hand.contact;
  ASSERT_TRUE(sample.touching);
  EXPECT_EQ(sample.body, 0U);
  EXPECT_EQ(sample.time.tick, simulation.time().tick);
  const double max_force = scene.hand.max_force;
  EXPECT_LT((sample.force - max_force * pull).norm(), 0.02 * max_force) << sample.force.transpose();
  const Vec3 outward = (sample.point - ball_centre).normalized();
  EXPECT_LT((sample.normal - outward).norm(), 0.02);
  const double normal_force = -sample.force.dot(sample.normal);
  EXPECT_NEAR(sample.impulse * scene.tick_rate, normal_force, 0.02 * max_force);
  // Rigid things yield by m·20/h², the hand being the only one that has a mass; up to four points share it.
  const double stiffness = 20 * scene.hand.mass * scene.tick_rate * scene.tick_rate;
  EXPECT_LT(sample.depth, 1.01 * normal_force / stiffness);
  EXPECT_GT(sample.depth, 0.99 * normal_force / stiffness / 4);
  EXPECT_NEAR((sample.point - ball_centre).norm(), ball_radius, sample.depth);
  EXPECT_LT((scene.rigid[0].pose * sample.local_point - sample.point).norm(), 1e-6);
  EXPECT_EQ(sample.impact, 0) << "met before this tick";
}

/// A block of tissue that nothing presses, with its top at y = 0.06.
SceneDesc over_tissue() {
  SceneDesc scene;
  scene.gravity.setZero();
  scene.rigid = {table()};
  scene.soft = {block()};
  return scene;
}
const Vec3 over_top(-0.004, 0.06, 0.045);

TEST(ContactSample, AnApproachIsToldUntilItsTimeOfImpact) {
  const SceneDesc scene = over_tissue();
  Simulation simulation(scene, options());
  constexpr double speed = 0.02;  // m/s
  const double h = 1 / scene.tick_rate;
  const auto wrist = [&](int tick) -> Vec3 { return over_top + Vec3(0, 0.04 - speed * h * tick, 0); };
  simulation.step(appear(wrist(0)));
  std::vector<double> foretold;  // s
  double met = -1;
  for (int tick = 1; tick < 400 && met < 0; ++tick) {
    simulation.step(target(wrist(tick)));
    const ContactSample& sample = simulation.hands()[0].contact;
    const double start = h * (static_cast<double>(simulation.time().tick) - 1);
    if (sample.touching) {
      EXPECT_GT(sample.impact, 0) << "it met something within this tick";
      EXPECT_LT(sample.impact, h);
      met = start + sample.impact;
    } else if (sample.impact >= 0) {
      EXPECT_EQ(sample.body, 1U);
      EXPECT_GT(sample.impact, h);
      EXPECT_EQ(sample.force.norm(), 0);
      EXPECT_EQ(sample.impulse, 0);
      EXPECT_LT(sample.depth, 0) << "a gap";
      EXPECT_GT(sample.normal.y(), 0.9);
      EXPECT_NEAR(sample.point.y(), 0.06, 1e-6);
      foretold.push_back(start + sample.impact);
    }
  }
  ASSERT_GT(met, 0);
  ASSERT_GE(foretold.size(), 2U);
  for (const double time : foretold) {
    EXPECT_NEAR(time, foretold.back(), 0.1 * h);
    EXPECT_NEAR(time, met, h);  // in the tick in which they meet, tissue begins to yield
  }
}

TEST(ContactSample, WhatIsLeftIsNotMet) {
  Simulation simulation(over_a_fixed_ball(), options());
  simulation.step(appear(over_ball + Vec3(0, 0.08, 0)));
  run(simulation, 60, target(over_ball + Vec3(0, 0.02, 0)));
  ASSERT_TRUE(simulation.hands()[0].contact.touching);
  for (int tick = 0; tick < 60; ++tick) {
    const double before = simulation.hands()[0].pose.p.y();
    simulation.step(target(over_ball + Vec3(0, 0.2, 0)));
    const ContactSample& sample = simulation.hands()[0].contact;
    if (simulation.hands()[0].pose.p.y() > before && !sample.touching) {
      EXPECT_LT(sample.impact, 0);
    }
  }
  EXPECT_FALSE(simulation.hands()[0].contact.touching);
}

TEST(ContactSample, OnTissueItTellsThePointAtRest) {
  const SceneDesc scene = over_tissue();
  Simulation simulation(scene, options());
  const Vec3 on_top = over_top + Vec3(0, 0.02, 0);
  simulation.step(appear(on_top + Vec3(0, 0.05, 0)));
  run(simulation, 120, target(on_top - Vec3(0, 0.02, 0)));
  const VecX at_start = simulation.soft_state(1).motion.x;
  simulation.step(target(on_top - Vec3(0, 0.02, 0)));
  const ContactSample& sample = simulation.hands()[0].contact;
  ASSERT_TRUE(sample.touching);
  EXPECT_EQ(sample.body, 1U);
  const soft::SoftBody& body = simulation.soft(1);
  const Anatomy& anatomy = body.anatomy();
  double nearest = 1;  // m: from where a face's point that rests there has come to
  for (const auto& corners : anatomy.surface.triangles) {
    Mat3 rest, now;
    for (Eigen::Index k = 0; k < 3; ++k) {
      const std::uint32_t vertex = corners[static_cast<std::size_t>(k)];
      rest.col(k) = anatomy.embedding.apply(vertex, body.rest().data());
      now.col(k) = anatomy.embedding.apply(vertex, at_start.data());
    }
    const Vec3 weights = rest.colPivHouseholderQr().solve(sample.local_point);
    if ((weights.array() < -1e-9).any() || std::abs(weights.sum() - 1) > 1e-9) continue;
    nearest = std::min(nearest, (now * weights - sample.point).norm());
  }
  EXPECT_LT(nearest, 1e-6);
  EXPECT_NEAR(sample.local_point.y(), 0.06, 1e-9);
  EXPECT_LT(sample.point.y(), sample.local_point.y() - 1e-3) << "pressed in";
  EXPECT_GT(sample.normal.y(), 0.9);
  // At rest it bears what the coupling pulls with, straight down.
  const double pull = -sample.force.y();
  EXPECT_GT(pull, 1);
  EXPECT_LE(pull, scene.hand.max_force * 1.001);
  EXPECT_LT(std::hypot(sample.force.x(), sample.force.z()), 0.1 * pull);
}

}  // namespace
}  // namespace prosector::test
