// What thumb and index hold by friction alone: nobody grasps, so nothing but contacts carries it.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "common/hand.h"
#include "server/physics/mechanics/contact/pad.h"
#include "server/physics/mechanics/soft/soft_body.h"
#include "tests/physics/scenes.h"

namespace prosector::test {
namespace {

constexpr std::size_t thumb_tip = 1, index_tip = 4;  // joints
constexpr double thumb = 0.6, opened = 0.1;          // flexion, and the index', less than where it touches
const Vec3 place(0, 0.3, 0);                         // of what is pinched, at first

using Flexion = std::array<double, fingers>;

/// Between the axes of thumb and index where they are nearest: both points, wrist frame.
std::pair<Vec3, Vec3> nearest(double index) {
  const auto poses = hand_pose(right_hand, {thumb, index, 0, 0, 0});
  std::pair<Vec3, Vec3> best;
  double least = 1;
  for (double s = 0; s <= 1; s += 0.02)
    for (double t = 0; t <= 1; t += 0.02) {
      const auto& segments = hand_segments(right_hand);
      const Vec3 a = poses[thumb_tip] * Vec3(0, 0, -s * segments[thumb_tip].length),
                 b = poses[index_tip] * Vec3(0, 0, -t * segments[index_tip].length);
      if ((a - b).norm() >= least) continue;
      least = (a - b).norm();
      best = {a, b};
    }
  return best;
}

/// A right hand around `place`, whose thumb and index have something between them, as far apart.
class Pinch {
 public:
  explicit Pinch(double thickness) {
    const auto& segments = hand_segments(right_hand);
    const double apart = thickness + segments[thumb_tip].radius + segments[index_tip].radius;
    double low = 0.5, high = 0.75;
    for (int i = 0; i < 20; ++i) {
      const auto [a, b] = nearest((low + high) / 2);
      ((a - b).norm() > apart ? low : high) = (low + high) / 2;
    }
    touching_ = low;
    const auto [a, b] = nearest(low);
    const Vec3 axis = (b - a).normalized();  // to x; up, so that no finger is below
    const Vec3 up = Vec3::UnitX().cross(axis).normalized();
    Mat3 frame;
    frame << axis, up, axis.cross(up);
    q_ = Quat(frame.transpose());
    middle_ = a + (segments[thumb_tip].radius + thickness / 2) * axis;
  }

  /// The pinching place `off` away from where it was, turned about it; closed: 0 to 1.
  TickInput at(const Vec3& off, double closed, double squeeze, double turned = 0) const {
    const Quat q = Quat(Eigen::AngleAxisd(turned, Vec3::UnitX())) * q_;
    TickInput out = target(place + off - q * middle_, q);
    const double index = touching_ - opened + closed * (opened + squeeze);
    out.targets[0].flexion = {thumb + (1 - closed) * 0.03 - closed * squeeze, index, 0, 0, 0};
    return out;
  }

 private:
  double touching_ = 0;
  Quat q_;
  Vec3 middle_;
};

/// How far what is pinched got in the hand: m, rad.
struct Slip {
  double moved = 0, turned = 0;
};

struct Handling {
  double squeeze = 0.2;  // of flexion, beyond where the fingers touch
  double swing = 0.04;   // m, to either side, at 0.5 Hz
  double turn = 0.4;     // rad, likewise
};

/// Of a soft one: its middle, not turned.
Pose pose_of(const Simulation& s, BodyId body) {
  if (s.kind(body) == BodyKind::rigid) return s.rigid_state(body).pose;
  const VecX& x = s.soft_state(body).motion.x;
  return {x.reshaped(3, x.size() / 3).rowwise().mean(), s.hands()[0].pose.q};
}

/// Closes the fingers on body 1, which stands on body 0.
void take(Simulation& simulation, const Pinch& hand, double squeeze) {
  run(simulation, 20);
  TickInput input = hand.at({0, 0.1, 0}, 0, squeeze);
  input.events.push_back({HandEvent::Kind::appear, somebody, right_hand, 0});
  simulation.step(input);
  run(simulation, 20, hand.at({0, 0.1, 0}, 0, squeeze));
  for (int i = 0; i <= 30; ++i) simulation.step(hand.at({0, 0.1 * (1 - i / 30.0), 0}, 0, squeeze));
  run(simulation, 10, hand.at({0, 0, 0}, 0, squeeze));
  for (int i = 0; i < 120; ++i) simulation.step(hand.at({0, 0, 0}, std::min(1.0, i / 30.0), squeeze));
}

/// Takes body 1, lifts it by 0.2 m, holds it for 3 s and swings it for 2 s; how far it moved in the hand
/// since the lift began.
Slip pinch(const SceneDesc& scene, double thickness, const Handling& how = {}) {
  Simulation simulation(scene, options());
  const Pinch hand(thickness);
  take(simulation, hand, how.squeeze);
  EXPECT_TRUE(simulation.hands()[0].contact.touching);
  const auto in_hand = [&] { return simulation.hands()[0].pose.inverse() * pose_of(simulation, 1); };
  const Pose before = in_hand();
  Slip slip;
  const auto look = [&] {
    const Pose now = in_hand();
    slip.moved = std::max(slip.moved, (now.p - before.p).norm());
    slip.turned = std::max(slip.turned, now.q.angularDistance(before.q));
    EXPECT_FALSE(simulation.hands()[0].holding);
  };
  for (int i = 0; i < 60; ++i) {
    simulation.step(hand.at({0, 0.2 * i / 60, 0}, 1, how.squeeze));
    look();
  }
  for (int i = 0; i < 180; ++i) {
    simulation.step(hand.at({0, 0.2, 0}, 1, how.squeeze));
    look();
  }
  for (int i = 0; i < 120; ++i) {
    const double phase = std::sin(std::numbers::pi * i / 60);
    simulation.step(hand.at({how.swing * phase, 0.2, how.swing * phase}, 1, how.squeeze, how.turn * phase));
    look();
  }
  return slip;
}

SceneDesc on_post(double bottom) {
  SceneDesc scene;
  scene.rigid = {part_body("post", "box", {0.01, 0.1, 0.01}, {0, place.y() - bottom - 0.05, 0})};
  scene.rigid[0].fixed = true;
  return scene;
}

SceneDesc ball(double density = 8000) {
  SceneDesc scene = on_post(0.008);
  scene.rigid.push_back(part_body("ball", "sphere", {0.016, 0, 0}, place, density));
  return scene;
}

// Two points would let it spin: then it turns by 3 rad.
TEST(Pinch, ABallNeitherSlipsNorSpins) {
  const Slip slip = pinch(ball(), 0.016);
  EXPECT_LT(slip.moved, 1e-3);
  EXPECT_LT(slip.turned, 0.01);
}

TEST(Pinch, ABoxNeitherSlipsNorTurns) {
  SceneDesc scene = on_post(0.006);
  scene.rigid.push_back(part_body("box", "box", {0.014, 0.012, 0.012}, place, 4000));
  const Slip slip = pinch(scene, 0.014);
  EXPECT_LT(slip.moved, 1e-3);
  EXPECT_LT(slip.turned, 0.01);
}

// Held by its end and turned, so that its weight turns it about the fingers: points let it swing by 0.9 rad.
// Some way is that of the fingers, which come to oppose each other once it stands on nothing.
TEST(Pinch, ARodHeldByItsEndDoesNotSwing) {
  SceneDesc scene = on_post(0.05);
  scene.rigid.push_back(part_body("rod", "box", {0.012, 0.06, 0.012}, place - Vec3(0, 0.02, 0), 1500));
  const Slip slip = pinch(scene, 0.012, {.turn = 0.8});
  EXPECT_LT(slip.moved, 8e-3);
  EXPECT_LT(slip.turned, 0.15);
}

TEST(Pinch, SmoothOrHeavyThingsSlip) {
  SceneDesc smooth = ball();
  smooth.rigid[1].contact.friction = 0.004;  // 3 N at either side bear 0.015 N of its 0.17 N
  EXPECT_GT(pinch(smooth, 0.016).moved, 0.05);
  EXPECT_GT(pinch(ball(2e5), 0.016).moved, 0.05);  // 4.2 N, of which they bear 1.9 N
}

TEST(Pinch, ASoftBlockDoesNotSlip) {
  SceneDesc scene = on_post(0.01);
  SoftDesc soft = block();
  soft.geometry.size = {0.016, 0.02, 0.016};
  soft.pose.p = place;
  soft.geometry.cell = soft.geometry.surface_cell = 0.004;
  soft.material.youngs_modulus = 5e4;
  scene.soft = {soft};
  EXPECT_LT(pinch(scene, 0.016).moved, 5e-3);
}

TEST(Pinch, GoesOnFromACheckpoint) {
  const Pinch hand(0.016);
  Simulation through(ball(), options()), restored(ball(), options());
  take(through, hand, 0.2);
  restored.restore(through.checkpoint());
  for (int i = 0; i < 30; ++i) {
    const TickInput lift = hand.at({0, 0.2 * i / 60, 0}, 1, 0.2);
    through.step(lift);
    restored.step(lift);
    ASSERT_EQ(restored.state_hash(), through.state_hash()) << i;
  }
  EXPECT_GT(through.rigid_state(1).pose.p.y(), place.y() + 0.08);
}

// As a patch of radius a under even pressure does.
TEST(Pad, BearsTwoThirdsOfItsRadiusOfMoment) {
  const Vec3 normal = Vec3(1, 2, -0.5).normalized();
  Vec3 sum = Vec3::Zero();
  for (const Vec3& at : contact::friction_points(normal, Vec3::UnitX(), 0.006)) {
    sum += at;
    EXPECT_NEAR(at.norm(), 0.004, 1e-12);
    EXPECT_NEAR(at.dot(normal), 0, 1e-15);
  }
  EXPECT_LT(sum.norm(), 1e-15);
}

}  // namespace
}  // namespace prosector::test
