// Bone breaks where the force through a plane exceeds what the scene states, and keeps its momentum.

#include <gtest/gtest.h>

#include <optional>

#include "common/error.h"
#include "tests/physics/scenes.h"

namespace prosector::test {
namespace {

constexpr BodyId bone = 0, above = 1, below = 2;
constexpr double half_mass = 1000 * 0.2 * 0.02 * 0.02 / 2;  // kg

/// A bar along x that may break in its middle, in free space.
SceneDesc bar(double break_force) {
  SceneDesc scene;
  scene.gravity = Vec3::Zero();
  scene.rigid = {part_body("bone", "box", {0.2, 0.02, 0.02}, {0, 0, 0})};
  scene.rigid[0].break_force = break_force;
  scene.rigid[0].fractures = {{{0, 0, 0}, {1, 0, 0}}};
  return scene;
}

/// Two hands, one at either end.
TickInput hands(double apart, std::optional<HandEvent::Kind> event = {}) {
  TickInput out;
  for (const ParticipantId who : {1, 2}) {
    HandTarget t;
    t.participant = who;
    t.target.p = {(who == 1 ? -1 : 1) * (0.07 + apart), 0.03, 0.045};
    out.targets.push_back(t);
    if (event) out.events.push_back({*event, who, right_hand, 0});
  }
  return out;
}

/// Grasps both ends and pulls, ever more, until a hand's coupling pulls with `newton` or the bone breaks. The
/// force that was reported then.
std::optional<double> pull(Simulation& simulation, double newton) {
  std::optional<double> broke;
  const auto step = [&](const TickInput& input) {
    for (const Broken& b : simulation.step(input).broken) broke = b.force;
  };
  step(hands(0, HandEvent::Kind::appear));
  step(hands(0, HandEvent::Kind::grasp));
  EXPECT_TRUE(simulation.hands()[0].holding && simulation.hands()[1].holding);
  double pulled = 0;
  for (int i = 0; i < 2000 && !broke && pulled < newton; ++i) {
    const TickInput input = hands(2e-5 * i);
    step(input);
    pulled = HandDesc().stiffness * (input.targets[1].target.p - simulation.hands()[1].pose.p).norm();
  }
  EXPECT_TRUE(broke || pulled >= newton);
  return broke;
}

TEST(Fracture, BreaksAboveTheThresholdAndNotBelow) {
  for (const double threshold : {10.0, 20.0, 30.0}) {
    Simulation gently(bar(threshold), options()), firmly(bar(threshold), options());
    EXPECT_FALSE(pull(gently, 0.95 * threshold)) << threshold;
    EXPECT_FALSE(gently.part(bone).hidden);
    EXPECT_TRUE(gently.part(above).hidden);
    const auto force = pull(firmly, 1.1 * threshold);
    ASSERT_TRUE(force) << threshold;
    EXPECT_GT(*force, threshold);
    EXPECT_LT(*force, 1.1 * threshold);
    EXPECT_TRUE(firmly.part(bone).hidden);
    EXPECT_FALSE(firmly.part(above).hidden);
    EXPECT_FALSE(firmly.part(below).hidden);
    // Either hand goes on with its piece.
    EXPECT_EQ(*firmly.hands()[0].holding, below);
    EXPECT_EQ(*firmly.hands()[1].holding, above);
    run(firmly, 60, hands(0.1));
    EXPECT_GT(firmly.rigid_state(above).pose.p.x(), 0.05);
    EXPECT_LT(firmly.rigid_state(below).pose.p.x(), -0.05);
  }
}

/// A hand presses on the bar, which is in its place, at `x`, ever more, until its coupling pushes with
/// `newton` or the bone breaks.
std::optional<double> press(Simulation& simulation, double x, double newton) {
  const auto at = [&](double depth) { return Vec3(x, 0.033 - depth, 0.045); };
  simulation.step(appear(at(0)));
  std::optional<double> broke;
  double pushed = 0;
  for (int i = 0; i < 3000 && !broke && pushed < newton; ++i) {
    const Vec3 wanted = at(1e-5 * i);
    for (const Broken& b : simulation.step(target(wanted)).broken) broke = b.force;
    pushed = HandDesc().stiffness * (simulation.hands()[0].pose.p - wanted).norm();
  }
  EXPECT_TRUE(broke || pushed >= newton);
  return broke;
}

// What is attached holds it by its middle.
TEST(Fracture, AnAttachedBoneBreaksWhereWhatStandsOutIsPressed) {
  constexpr double threshold = 15;
  const auto attached = [] {
    SceneDesc scene = bar(threshold);
    scene.rigid[0].part = true;
    scene.rigid[0].fractures = {{{0.02, 0, 0}, {1, 0, 0}}};
    return scene;
  };
  constexpr double end = 0.09, middle = -0.04;
  Simulation gently(attached(), options()), firmly(attached(), options()), held(attached(), options());
  EXPECT_FALSE(press(gently, end, 0.9 * threshold));
  EXPECT_FALSE(gently.part(bone).hidden);
  const auto force = press(firmly, end, 1.2 * threshold);
  ASSERT_TRUE(force);
  EXPECT_GT(*force, threshold);
  EXPECT_LT(*force, 1.2 * threshold);
  EXPECT_TRUE(firmly.part(bone).hidden);
  EXPECT_FALSE(firmly.part(above).hidden);
  EXPECT_FALSE(firmly.part(below).hidden);
  EXPECT_FALSE(press(held, middle, 2 * threshold)) << "nothing passes through the plane";
}

TEST(Fracture, MomentumIsKept) {
  SceneDesc unbreakable = bar(1e5), scene = bar(15);
  Simulation whole(unbreakable, options()), simulation(scene, options());
  // Drawn sideways and around while pulled apart, so that there is momentum to keep.
  const auto input = [](int i) {
    TickInput out = hands(0.012 * std::min(1.0, i / 40.0), i == 0   ? std::optional(HandEvent::Kind::appear)
                                                           : i == 1 ? std::optional(HandEvent::Kind::grasp)
                                                                    : std::nullopt);
    out.targets[0].target.p.y() += 2e-4 * i;
    out.targets[1].target.p.y() -= 1e-4 * i;
    return out;
  };
  bool broke = false;
  for (int i = 0; i < 120 && !broke; ++i) {
    whole.step(input(i));
    broke = !simulation.step(input(i)).broken.empty();
  }
  ASSERT_TRUE(broke);
  const RigidBodyState one = whole.rigid_state(bone);
  Vec3 momentum = Vec3::Zero(), spin = Vec3::Zero();
  const Mat3 R = one.pose.q.toRotationMatrix();
  const auto inertia = [&](double mass, double length) {
    const double thick = 0.02 * 0.02;
    return Mat3(R *
                (mass / 12 * Vec3(2 * thick, length * length + thick, length * length + thick)).asDiagonal() *
                R.transpose());
  };
  for (const BodyId piece : {above, below}) {
    const RigidBodyState s = simulation.rigid_state(piece);
    const Vec3 arm = R * Vec3(piece == above ? 0.05 : -0.05, 0, 0);
    const Vec3 v =
        s.linear_velocity + s.angular_velocity.cross(arm);  // of its middle: it moves as its frame says
    momentum += half_mass * v;
    spin += half_mass * arm.cross(v) + inertia(half_mass, 0.1) * s.angular_velocity;
  }
  const Vec3 momentum_before = 2 * half_mass * one.linear_velocity;
  const Vec3 spin_before = inertia(2 * half_mass, 0.2) * one.angular_velocity;
  EXPECT_GT(momentum_before.norm(), 1e-5);
  EXPECT_GT(spin_before.norm(), 1e-7);
  EXPECT_LT((momentum - momentum_before).norm(), 1e-5 * momentum_before.norm());
  EXPECT_LT((spin - spin_before).norm(), 1e-3 * spin_before.norm());
}

TEST(Fracture, RestsAndFallsWithoutBreakingUntilItHitsHardEnough) {
  const auto dropped = [](double height, double threshold) {
    SceneDesc scene = bar(threshold);
    scene.gravity = {0, -9.81, 0};
    // On two blocks under its ends, so that what stops its middle passes through the plane.
    scene.rigid[0].pose.p = {0, 0.06 + height, 0};
    scene.rigid[0].fractures[0].point = {0.05, 0, 0};
    scene.rigid.push_back(part_body("left", "box", {0.02, 0.05, 0.1}, {-0.08, 0.025, 0}));
    scene.rigid.push_back(part_body("right", "box", {0.02, 0.05, 0.1}, {0.08, 0.025, 0}));
    scene.rigid[1].fixed = scene.rigid[2].fixed = true;
    Simulation simulation(scene, options());
    run(simulation, 120);
    return simulation.part(bone).hidden;
  };
  // At rest a quarter of its weight, 0.2 N, passes through.
  EXPECT_FALSE(dropped(0, 1));
  EXPECT_FALSE(dropped(0.2, 100));
  EXPECT_TRUE(dropped(0.2, 1));
}

TEST(Fracture, StateIsSavedAndPutBackByAReset) {
  Simulation simulation(bar(15), options()), other(bar(15), options());
  ASSERT_TRUE(pull(simulation, 20));
  other.restore(simulation.checkpoint());
  run(simulation, 30, hands(0.05));
  run(other, 30, hands(0.05));
  EXPECT_EQ(other.state_hash(), simulation.state_hash());
  for (const BodyId asked : {bone, above}) {
    other.restore(simulation.checkpoint());
    TickInput reset = hands(0.05);
    reset.events.push_back({HandEvent::Kind::reset_body, 0, 0, asked});
    other.step(reset);
    EXPECT_FALSE(other.part(bone).hidden);
    EXPECT_TRUE(other.part(above).hidden);
    EXPECT_TRUE(other.part(below).hidden);
    EXPECT_FALSE(other.hands()[0].holding);
    EXPECT_LT(other.rigid_state(bone).pose.p.norm(), 1e-3);
  }
}

TEST(Fracture, TwoPlanesMakePiecesThatBreakFurther) {
  SceneDesc scene = bar(15);
  scene.rigid[0].fractures = {{{-0.03, 0, 0}, {1, 0, 0}}, {{0.03, 0, 0}, {1, 0, 0}}};
  Simulation simulation(scene, options());
  // Two pieces for either plane, and of the longer of these two more.
  EXPECT_EQ(simulation.body_count(), 1U + 4U + 4U);
  ASSERT_TRUE(pull(simulation, 20));
}

TEST(Fracture, PlanesThatMissAreRefused) {
  SceneDesc scene = bar(15);
  scene.rigid[0].fractures[0].point.x() = 1;
  EXPECT_THROW(Simulation(scene, options()), InputError);
}

}  // namespace
}  // namespace prosector::test
