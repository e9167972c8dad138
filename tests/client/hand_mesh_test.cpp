// The skin of hands and their nails: closed, smooth, and where the bones are.

#include "client/view/hand_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "client/view/hand_nails.h"
#include "common/hands/hand_field.h"
#include "common/ids.h"

namespace prosector {
namespace {

const HandSkin& skin(std::size_t hand) {
  static const std::array<HandSkin, 2> skins = {HandSkin(left_hand), HandSkin(right_hand)};
  return skins.at(hand);
}

std::array<double, fingers> all(double flexion) {
  return {flexion, flexion, flexion, flexion, flexion};
}

TEST(HandNails, RiseALittleFromTheSkinAndSinkIntoItAtTheirRims) {
  const auto nails = make_nails(right_hand, 1);
  const std::size_t points = nails->positions.size() / fingers;
  for (std::size_t finger = 0; finger < fingers; ++finger) {
    const Vec3 top = nails->positions[finger * points].cast<double>();
    EXPECT_GT(hand_field(top).solid, 0) << finger;
    EXPECT_LT(hand_field(top).solid, 0.003) << finger;
    const Vec3 rim = nails->positions[(finger + 1) * points - 1].cast<double>();
    EXPECT_LT(hand_field(rim).solid, 0) << finger;
  }
}

TEST(HandNails, GoWithTheFingertips) {
  for (const std::size_t hand : {left_hand, right_hand}) {
    const auto nails = make_nails(hand, 1);
    bend_nails(hand, all(0.7), *nails);
    const auto mesh = make_hand_mesh(skin(hand), 2);
    bend_hand(skin(hand), *mesh, all(0.7));
    const std::size_t points = nails->positions.size() / fingers;
    for (std::size_t finger = 0; finger < fingers; ++finger) {
      float nearest = 1;
      for (const auto& x : mesh->positions)
        nearest = std::min(nearest, (x - nails->positions[finger * points]).norm());
      EXPECT_LT(nearest, 0.006F) << "hand " << hand << ", finger " << finger;
    }
  }
}

TEST(HandMesh, IsOneClosedSkin) {
  for (const std::size_t hand : {left_hand, right_hand}) {
    const auto mesh = make_hand_mesh(skin(hand), 1);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    double volume = 0;
    for (const auto& t : mesh->triangles) {
      for (std::size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
      volume += mesh->positions[t[0]].dot(mesh->positions[t[1]].cross(mesh->positions[t[2]])) / 6.0;
    }
    for (const auto& [edge, count] : edges) {
      ASSERT_EQ(count, 1);
      ASSERT_TRUE(edges.contains({edge.second, edge.first}));
    }
    // Closed and without handles: V − E + F = 2.
    EXPECT_EQ(static_cast<long>(mesh->positions.size()) - static_cast<long>(edges.size() / 2) +
                  static_cast<long>(mesh->triangles.size()),
              2);
    EXPECT_GT(volume, 250e-6) << "an adult hand with its wrist displaces 300 to 500 ml";
    EXPECT_LT(volume, 550e-6);
    EXPECT_LT(mesh->triangles.size(), 12000u);
  }
}

TEST(HandMesh, HasFiniteUnitNormalsAtEveryBend) {
  for (int step = 0; step <= 8; ++step) {
    const SkinnedHand bent = skin_hand(skin(right_hand), all(step / 8.0));
    for (const auto& x : bent.positions) ASSERT_TRUE(x.allFinite());
    for (const auto& n : bent.normals) ASSERT_NEAR(n.norm(), 1, 1e-4);
  }
}

TEST(HandMesh, LeftIsTheMirrorOfRight) {
  const std::array<double, fingers> flexion = {0.3, 0.9, 0.1, 0.6, 1.0};
  const SkinnedHand left = skin_hand(skin(left_hand), flexion), right = skin_hand(skin(right_hand), flexion);
  ASSERT_EQ(left.positions.size(), right.positions.size());
  for (std::size_t k = 0; k < left.positions.size(); ++k) {
    const Eigen::Vector3f mirror(-1, 1, 1);
    ASSERT_LT((left.positions[k] - right.positions[k].cwiseProduct(mirror)).norm(), 1e-5F);
    ASSERT_LT((left.normals[k] - right.normals[k].cwiseProduct(mirror)).norm(), 2e-3F);
  }
}

/// The drawn skin stays on the bones that touch: its nearest vertex to each bone's tip is within a finger's
/// breadth of the flesh there.
TEST(HandMesh, FollowsTheBones) {
  for (const double flexion : {0.0, 0.4, 0.8, 1.0}) {
    const SkinnedHand bent = skin_hand(skin(right_hand), all(flexion));
    const auto bones = hand_pose(right_hand, all(flexion));
    for (const HandSegment& s : hand_segments(right_hand)) {
      const Vec3 tip = bones[s.joint] * Vec3(0, 0, -s.length);
      double nearest = 1;
      for (const auto& x : bent.positions) nearest = std::min(nearest, (x.cast<double>() - tip).norm());
      EXPECT_LT(nearest, 1.35 * s.radius) << "joint " << s.joint << " flexion " << flexion;
    }
  }
}

TEST(HandMesh, AFistClosesOverThePalm) {
  const auto open = make_hand_mesh(skin(right_hand), 1);
  const SkinnedHand fist = skin_hand(skin(right_hand), all(1));
  float open_reach = 0, fist_reach = 0;
  for (std::size_t k = 0; k < fist.positions.size(); ++k) {
    open_reach = std::min(open_reach, open->positions[k].z());
    fist_reach = std::min(fist_reach, fist.positions[k].z());
  }
  EXPECT_LT(open_reach, -0.175F);
  EXPECT_GT(fist_reach, -0.115F) << "only the knuckles are left in front";
  // The middle fingertip: farthest forward of the open hand.
  for (std::size_t k = 0; k < fist.positions.size(); ++k)
    if (open->positions[k].z() < open_reach + 0.004F) {
      EXPECT_LT(fist.positions[k].y(), -0.005F) << "below the palm";
      EXPECT_GT(fist.positions[k].y(), -0.05F);
      EXPECT_GT(fist.positions[k].z(), -0.09F) << "over the palm";
      EXPECT_LT(fist.positions[k].z(), 0.0F);
    }
}

TEST(HandMesh, OneFingerLeavesTheOthersAlone) {
  const auto open = make_hand_mesh(skin(right_hand), 1);
  const SkinnedHand point = skin_hand(skin(right_hand), {0, 1, 0, 0, 0});
  const auto bones = hand_pose(right_hand, {});
  for (const std::size_t tip : {1U, 7U, 10U, 13U}) {
    const HandSegment& s = hand_segments(right_hand)[tip];
    const Vec3 middle = bones[tip] * Vec3(0, 0, -s.length / 2);
    for (std::size_t k = 0; k < point.positions.size(); ++k)
      if ((open->positions[k].cast<double>() - middle).norm() < 1.2 * s.radius) {
        ASSERT_LT((open->positions[k] - point.positions[k]).norm(), 1e-3F) << "tip of joint " << tip;
      }
  }
}

TEST(HandMesh, BendingKeepsTheFleshOnTheBackOfTheJoints) {
  const auto open = make_hand_mesh(skin(right_hand), 1);
  const SkinnedHand fist = skin_hand(skin(right_hand), {0, 0, 1, 0, 0});
  // The middle finger's PIP: distance of the skin from the joint's centre on its dorsal side.
  const auto rest = hand_pose(right_hand, {});
  const auto bent = hand_pose(right_hand, {0, 0, 1, 0, 0});
  int seen = 0;
  for (std::size_t k = 0; k < fist.positions.size(); ++k) {
    const Vec3 local = rest[6].inverse() * open->positions[k].cast<double>();
    if (std::abs(local.z()) > 0.002 || local.y() < 0.006 || std::abs(local.x()) > 0.008) continue;
    const double before = local.norm();
    const double after = (fist.positions[k].cast<double>() - bent[6].p).norm();
    EXPECT_NEAR(after, before, 0.25 * before);
    ++seen;
  }
  EXPECT_GT(seen, 2);
}

}  // namespace
}  // namespace prosector
