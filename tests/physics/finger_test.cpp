// Fingers bend with a bounded force, and stop on what resists.

#include <gtest/gtest.h>

#include <random>

#include "common/hand.h"
#include "server/physics/mechanics/hands/finger_drive.h"
#include "tests/physics/scenes.h"

namespace prosector::test {
namespace {

using Flexion = std::array<double, fingers>;

TickInput hand_at(const Vec3& place, const Flexion& flexion) {
  TickInput out = target(place);
  out.targets[0].flexion = flexion;
  return out;
}

double resistance(double step, const std::vector<hands::Obstacle>& obstacles) {
  double sum = 0;
  for (const hands::Obstacle& o : obstacles)
    sum +=
        std::max(0.0, o.stiffness * std::max(0.0, -o.gap) + o.series * (o.way * step - std::max(0.0, o.gap)));
  return sum;
}

TEST(FingerStep, FollowsWhereNothingIsInTheWay) {
  for (const double tracked : {0.0, 0.3, 1.0})
    for (const double flexion : {0.0, 0.4, 0.9})
      EXPECT_EQ(hands::finger_step(tracked, flexion, 0.1, {}, {8}), std::clamp(tracked - flexion, -0.1, 0.1));
}

TEST(FingerStep, NeverPushesHarderThanItsBound) {
  std::mt19937 random(3);
  const auto number = [&](double lo, double hi) {
    return std::uniform_real_distribution<double>(lo, hi)(random);
  };
  const hands::FingerDrive drive{.max_force = 8};
  for (int i = 0; i < 5000; ++i) {
    std::vector<hands::Obstacle> obstacles(1 + random() % 5);
    for (hands::Obstacle& o : obstacles) {
      o.stiffness = std::pow(10, number(1, 6));
      o.series = o.stiffness * number(0.01, 1);
      o.gap = number(-8 / o.stiffness / 5, 0.01);
      o.way = number(0.001, 0.1);
    }
    const double flexion = number(0, 1), tracked = number(0, 1);
    const double step = hands::finger_step(tracked, flexion, 0.13, obstacles, drive);
    EXPECT_GE(flexion + step, -1e-12);
    EXPECT_LE(flexion + step, 1 + 1e-12);
    if (flexion + step > 1e-6) {
      EXPECT_LE(resistance(step, obstacles), drive.max_force * 1.001) << i;
    }
    EXPECT_LE(step, std::max(0.0, tracked - flexion) + 1e-12) << "not beyond where it is tracked";
  }
}

TEST(FingerStep, RestsOnWhatIsHardWithTheWholeForce) {
  const hands::Obstacle wall{0.004, 0.08, 3e4, 3e4};
  double flexion = 0.2, gap = wall.gap;
  for (int tick = 0; tick < 60; ++tick) {
    const double step =
        hands::finger_step(1, flexion, 0.13, std::vector{hands::Obstacle{gap, wall.way, 3e4, 3e4}}, {8});
    flexion += step;
    gap -= wall.way * step;
  }
  EXPECT_NEAR(-gap * wall.stiffness, 8, 0.01);
  EXPECT_LT(flexion, 0.3);
}

SceneDesc ball_in_hand(double radius, const Vec3& at) {
  SceneDesc scene;
  scene.gravity = Vec3::Zero();
  scene.rigid = {part_body("ball", "sphere", {2 * radius, 0, 0}, at)};
  return scene;
}

/// m: how deep the deepest of the four fingers' and the thumb's axes and radii are in the ball.
double deepest(const HandState& hand, const Vec3& ball, double radius) {
  double depth = 0;
  const auto poses = hand_pose(hand.hand, hand.flexion);
  for (const HandSegment& s : hand_segments(hand.hand))
    for (double share = 0; share <= 1; share += 0.1) {
      const Vec3 at = hand.pose * (poses[s.joint] * Vec3(0, 0, -share * s.length));
      depth = std::max(depth, radius + s.radius - (at - ball).norm());
    }
  return depth;
}

TEST(Fingers, AFistStopsAtABallAndPressesNoHarderThanItsBound) {
  constexpr double radius = 0.03;
  for (const double max_force : {20.0, 40.0}) {
    SceneDesc scene = ball_in_hand(radius, {-0.002, -0.012 - radius, -0.085});
    scene.hand.max_force = max_force;
    Simulation simulation(scene, options());
    simulation.step(appear(Vec3::Zero()));
    const TickInput fist = hand_at(Vec3::Zero(), {1, 1, 1, 1, 1});
    double most = 0;
    for (int i = 0; i < 120; ++i) {
      simulation.step(fist);
      most = std::max(most, simulation.hands()[0].contact.impulse * scene.tick_rate);
    }
    const HandState& hand = simulation.hands()[0];
    EXPECT_TRUE(hand.contact.touching);
    EXPECT_LT(deepest(hand, simulation.rigid_state(0).pose.p, radius), 5e-4);
    for (const std::size_t finger : {1, 2, 3}) EXPECT_LT(hand.flexion[finger], 0.9) << finger;
    // Five fingers press, each with a fifth of the bound at most, and what they press against presses back.
    EXPECT_LT(most, 2 * max_force);
    EXPECT_GT(hand.contact.impulse * scene.tick_rate, 0.1 * max_force) << "they do press";
    const TickInput open = hand_at(Vec3::Zero(), {});
    run(simulation, 60, open);
    EXPECT_EQ(simulation.hands()[0].flexion, Flexion{}) << "and open again";
  }
}

TEST(Fingers, AStiffSoftBlockStopsThem) {
  for (const double youngs_modulus : {5e4, 2e5}) {
    SceneDesc scene;
    scene.gravity = Vec3::Zero();
    scene.soft = {block()};
    scene.soft[0].material.youngs_modulus = youngs_modulus;
    scene.soft[0].attach = {{{0, 0, 0}, 0.2, 1e9}};
    Simulation simulation(scene, options());
    scene.soft[0].geometry.cell = scene.soft[0].geometry.surface_cell = 0.01;
    const Vec3 above(0, 0.06 + 0.013, 0.12);  // the stretched fingers just over the block's top
    simulation.step(appear(above));
    double most = 0;
    for (int i = 0; i < 120; ++i) {
      simulation.step(hand_at(above, {0, 1, 1, 1, 1}));
      most = std::max(most, simulation.hands()[0].contact.impulse * scene.tick_rate);
    }
    EXPECT_LT(simulation.hands()[0].flexion[2], 0.5) << youngs_modulus;
    EXPECT_LT(most, 2 * scene.hand.max_force) << youngs_modulus;
  }
}

}  // namespace
}  // namespace prosector::test
