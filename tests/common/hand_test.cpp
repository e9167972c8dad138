#include "common/hand.h"
#include "common/ids.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace prosector {
namespace {

constexpr double degree = std::numbers::pi / 180;
using Flexion = std::array<double, fingers>;

Vec3 tip(std::size_t hand, const Flexion& flexion, std::size_t joint) {
  return hand_pose(hand, flexion)[joint] * Vec3(0, 0, -hand_segments(hand)[joint].length);
}

TEST(Hand, JointRule) {
  for (int n = 0; n <= 20; ++n) {
    const double x = n / 20.0;
    const auto angle = joint_angles({x, x, x, x, x});
    EXPECT_NEAR(angle[0], x * 90 * degree, 1e-12);  // thumb
    EXPECT_NEAR(angle[1], x * 90 * degree, 1e-12);
    for (std::size_t mcp = 2; mcp < hand_joints; mcp += 3) {
      const double m = angle[mcp] / (90 * degree), p = angle[mcp + 1] / (90 * degree);
      constexpr double c1 = 2.0 / 3, c4 = 1.0 / 3;
      EXPECT_NEAR(c1 * m + c4 * p, x, 1e-12);
      EXPECT_NEAR(c1 * m, 2 * c4 * p, 1e-12);
      EXPECT_NEAR(angle[mcp + 2], 2.0 / 3 * angle[mcp + 1], 1e-12);
    }
  }
}

TEST(Hand, OneSensorBendsOneFinger) {
  const auto open = joint_angles({});
  for (std::size_t finger = 0; finger < fingers; ++finger) {
    Flexion flexion{};
    flexion[finger] = 1;
    const auto angle = joint_angles(flexion);
    const std::size_t first = finger == 0 ? 0 : 2 + 3 * (finger - 1), count = finger == 0 ? 2 : 3;
    for (std::size_t j = 0; j < hand_joints; ++j)
      EXPECT_EQ(angle[j] > open[j], j >= first && j < first + count) << finger << " " << j;
  }
}

TEST(Hand, ValuesOutsideAreClamped) {
  EXPECT_EQ(joint_angles({-3, -0.1, 0, 0, 0}), joint_angles({}));
  EXPECT_EQ(joint_angles({1.5, 2, 100, 1, 1}), joint_angles({1, 1, 1, 1, 1}));
}

// Open, the fingers point along −z; closed, every fingertip is below the palm and back at it.
TEST(Hand, FullFlexionIsAClosedFist) {
  const Flexion open{}, fist = {1, 1, 1, 1, 1};
  for (const std::size_t hand : {left_hand, right_hand}) {
    const Palm palm = hand_palm(hand);
    for (std::size_t dip = 4; dip < hand_joints; dip += 3) {
      const Vec3 knuckle = hand_segments(hand)[dip - 2].origin;
      EXPECT_LT(tip(hand, open, dip).z(), knuckle.z() - 0.06);
      EXPECT_NEAR(tip(hand, open, dip).y(), knuckle.y(), 1e-9);
      const Vec3 closed = tip(hand, fist, dip);
      EXPECT_LT(closed.y(), palm.center.y() - palm.half_extents.y() * 0.5);
      EXPECT_GT(closed.z(), knuckle.z());
      EXPECT_LT((closed - palm.center).norm(), 0.06);
    }
  }
}

TEST(Hand, LeftIsTheMirrorOfRight) {
  for (const Flexion& flexion : {Flexion{}, Flexion{0.2, 0.9, 0.4, 0.6, 0.1}, Flexion{1, 1, 1, 1, 1}})
    for (std::size_t j = 0; j < hand_joints; ++j) {
      const Vec3 l = tip(left_hand, flexion, j), r = tip(right_hand, flexion, j);
      EXPECT_NEAR((l - Vec3(-r.x(), r.y(), r.z())).norm(), 0, 1e-12) << j;
    }
  EXPECT_EQ(hand_palm(left_hand).center.x(), -hand_palm(right_hand).center.x());
}

// Whatever the flexion, segments stay joined: a segment begins where its parent ends.
TEST(Hand, SegmentsStayJoined) {
  for (const std::size_t hand : {left_hand, right_hand})
    for (int n = 0; n < 32; ++n) {
      Flexion flexion;
      for (std::size_t f = 0; f < fingers; ++f) flexion[f] = (n >> f) & 1;
      const auto pose = hand_pose(hand, flexion);
      for (const HandSegment& s : hand_segments(hand)) {
        EXPECT_NEAR(pose[s.joint].q.norm(), 1, 1e-12);
        if (s.parent < 0) continue;
        const auto parent = static_cast<std::size_t>(s.parent);
        EXPECT_NEAR((pose[s.joint].p - tip(hand, flexion, parent)).norm(), 0, 1e-12);
      }
    }
}

}  // namespace
}  // namespace prosector
