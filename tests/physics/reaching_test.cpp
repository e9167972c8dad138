// Fingers of fast hands stop at thin rigid bodies.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "common/hand.h"
#include "tests/physics/scenes.h"

namespace prosector::test {
namespace {

constexpr double tick_seconds = 1.0 / 60;
const std::vector<double> speeds = {0.2, 0.5, 1.0, 2.0, 3.0};          // m/s
const std::vector<double> starts = {0.2, 0.205, 0.211, 0.216, 0.222};  // m above: other remainders

/// Returns the lowest point of all finger segments, m.
double lowest_of_fingers(const HandState& hand) {
  const auto poses = hand_pose(hand.hand, hand.flexion);
  double lowest = std::numeric_limits<double>::infinity();
  for (const HandSegment& s : hand_segments(hand.hand))
    for (const double end : {-1, 0}) {
      const Vec3 at = hand.pose * (poses[s.joint] * Vec3(0, 0, end * s.length));
      lowest = std::min(lowest, at.y() - s.radius);
    }
  return lowest;
}

/// Moves a hand from `start` above the ground straight down to `end`, both m, at that speed (m/s), and keeps
/// it there. Calls check() after each tick.
template <class Check>
void lower_hand(Simulation& simulation, double start, double end, double speed, const Check& check) {
  const Vec3 above(0, start, 0.08);
  simulation.step(appear(above));
  for (int k = 1; k <= 60; ++k) {
    simulation.step(target({above.x(), std::max(end, start - k * speed * tick_seconds), above.z()}));
    check();
  }
}

SceneDesc thin_plate(double thickness) {
  SceneDesc scene;
  scene.rigid = {part_body("plate", "box", {1, thickness, 1}, {0, -thickness / 2, 0})};
  scene.rigid[0].fixed = true;
  return scene;
}

TEST(Reaching, FingersStayOnThinPlates) {
  for (const double thickness : {0.0005, 0.002, 0.006})
    for (const double speed : speeds)
      for (const double start : starts) {
        SCOPED_TRACE(testing::Message() << "plate " << thickness << ", " << speed << " m/s, " << start);
        Simulation simulation(thin_plate(thickness), options());
        double lowest = start;
        lower_hand(simulation, start, -0.03, speed,
                   [&] { lowest = std::min(lowest, lowest_of_fingers(simulation.hands()[0])); });
        EXPECT_GT(lowest, -0.0015);
      }
}

TEST(Reaching, AKnifeUnderTheFingersStaysOnItsTray) {
  for (const double speed : speeds)
    for (const double start : starts) {
      SCOPED_TRACE(testing::Message() << speed << " m/s, " << start);
      SceneDesc scene = thin_plate(0.006);
      scene.rigid.push_back(part_body("knife", "box", {0.014, 0.004, 0.12}, {0, 0.002, 0}, 3000));
      Simulation simulation(scene, options());
      double spin = 0;
      lower_hand(simulation, start, 0.0, speed, [&] {
        const RigidBodyState knife = simulation.rigid_state(1);
        spin = std::max(spin, knife.angular_velocity.norm());
        EXPECT_GT(knife.pose.p.y(), 0.001);
      });
      EXPECT_LT(spin, 10);
    }
}

/// Returns the lowest corner of a box, m.
double lowest_corner(const Pose& pose, const Vec3& size) {
  double lowest = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 8; ++k) {
    const Vec3 sign((k & 1) != 0 ? 0.5 : -0.5, (k & 2) != 0 ? 0.5 : -0.5, (k & 4) != 0 ? 0.5 : -0.5);
    lowest = std::min(lowest, (pose * Vec3(sign.cwiseProduct(size))).y());
  }
  return lowest;
}

TEST(Reaching, AHeldKnifeStaysOnPlatesAndInTheHand) {
  const Vec3 size(0.014, 0.004, 0.2);
  for (const double thickness : {0.006, 0.02})
    for (const double speed : {0.2, 0.5, 1.0})
      for (const double start : starts) {
        SCOPED_TRACE(testing::Message() << "plate " << thickness << ", " << speed << " m/s, " << start);
        SceneDesc scene = thin_plate(thickness);
        scene.rigid.push_back(part_body("knife", "box", size, {0, 0.002, -0.06}, 3000));
        Simulation simulation(scene, options());
        const Vec3 low(0, 0.03, 0.08);
        simulation.step(appear(low));
        TickInput grasp = target(low);
        grasp.events.push_back({HandEvent::Kind::grasp_body, somebody, right_hand, 1});
        simulation.step(grasp);
        ASSERT_TRUE(simulation.hands()[0].holding);
        for (int k = 1; k <= 60; ++k) simulation.step(target(low + Vec3(0, (start - low.y()) * k / 60.0, 0)));
        double lowest = start;
        for (int k = 1; k <= 60; ++k) {
          simulation.step(target({0, std::max(-0.03, start - k * speed * tick_seconds), 0.08}));
          lowest = std::min(lowest, lowest_corner(simulation.rigid_state(1).pose, size));
        }
        EXPECT_GT(lowest, -thickness / 2);
        EXPECT_TRUE(simulation.hands()[0].holding);
      }
}

TEST(Reaching, AFastHandThatPassesABodyLeavesItAlone) {
  SceneDesc scene;
  scene.gravity = Vec3::Zero();
  scene.rigid = {part_body("knife", "box", {0.014, 0.004, 0.12}, {0, 0, 0}, 3000)};
  Simulation simulation(scene, options());
  simulation.step(appear({-0.3, 0.04, 0.08}));
  for (int k = 1; k <= 60; ++k)
    simulation.step(target({std::min(0.3, -0.3 + 3 * k * tick_seconds), 0.04, 0.08}));
  EXPECT_GT(simulation.hands()[0].pose.p.x(), 0.29);
  EXPECT_EQ(simulation.rigid_state(0).pose.p, Vec3::Zero());
}

}  // namespace
}  // namespace prosector::test
