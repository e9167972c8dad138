// The hand laid through points: exact where they are exact, unsure where they are none of a hand.
#include "drivers/camera/hands/hand_fit.h"
#include "idl/message.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/hands/hand_pictures.h"

namespace prosector {
namespace {

HandView view_of(const HandScene& scene, const PosedHand& hand) {
  return {true_points(scene, hand), scene.lens, scene.camera_rig};
}

/// Shows one hand of any side and size, without pictures.
HandScene shown(Random& random) {
  HandScene scene;
  scene.lens = webcam();
  PosedHand hand = random_hand(random, 0.3, 0.8);
  hand.size = random.uniform(0.8, 1.15);
  scene.hands = {hand};
  return scene;
}

TEST(HandFit, FindsTheHandThatMadeThePoints) {
  Random random(1);
  int right = 0, sure = 0;
  constexpr int tries = 200;
  for (int k = 0; k < tries; ++k) {
    const HandScene scene = shown(random);
    const PosedHand& hand = scene.hands[0];
    const HandView view = view_of(scene, hand);
    const auto fit = fit_hand({&view, 1}, {hand.hand, hand.size}, std::nullopt);
    ASSERT_TRUE(fit);
    sure += fit->sure;
    double bend = 0;
    for (std::size_t f = 0; f < fingers; ++f)
      bend = std::max(bend, std::abs(fit->flexion[f] - hand.flexion[f]));
    right += (fit->wrist.p - hand.camera_wrist.p).norm() < 0.003 &&
             fit->wrist.q.angularDistance(hand.camera_wrist.q) < 0.02 && bend < 0.05;
  }
  EXPECT_GE(right, tries * 97 / 100) << "two starts find all but a few";
  EXPECT_GE(sure, tries * 85 / 100);
}

TEST(HandFit, GoesOnFromWhereTheHandWas) {
  Random random(2);
  for (int k = 0; k < 100; ++k) {
    const HandScene scene = shown(random);
    const PosedHand& hand = scene.hands[0];
    HandFit before{hand.camera_wrist, hand.flexion, 1, 0, true};
    before.wrist.p += random.point(0.01);
    before.wrist.q =
        (Quat(Eigen::AngleAxisd(random.uniform(-0.1, 0.1), random.point(1).normalized())) * before.wrist.q)
            .normalized();
    for (double& bend : before.flexion) bend = std::clamp(bend + random.uniform(-0.1, 0.1), 0.0, 1.0);
    const HandView view = view_of(scene, hand);
    const auto fit = fit_hand({&view, 1}, {hand.hand, hand.size}, before);
    ASSERT_TRUE(fit && fit->sure);
    EXPECT_LT((fit->wrist.p - hand.camera_wrist.p).norm(), 0.003) << k;
    EXPECT_LT(fit->miss, 0.002);
  }
}

TEST(HandFit, MeasuresDepthByASecondCamera) {
  Random random(3);
  double one = 0, two = 0;
  for (int k = 0; k < 60; ++k) {
    HandScene scene = shown(random);
    const PosedHand hand = scene.hands[0];
    std::vector<HandView> views;
    for (const double x : {0.0, -0.12}) {
      scene.camera_rig = {Vec3(x, 0, 0), Quat::Identity()};
      views.push_back(view_of(scene, hand));
      for (Vec2& p : views.back().points) p += Vec2(random.uniform(-3, 3), random.uniform(-3, 3));
    }
    const HandFit before{hand.camera_wrist, hand.flexion, 1, 0, true};
    const auto off = [&](std::size_t cameras) {
      const auto fit = fit_hand(std::span(views).first(cameras), {hand.hand, hand.size}, before);
      return std::abs((fit.value().wrist.p - hand.camera_wrist.p).z());
    };
    one += off(1) / 60;
    two += off(2) / 60;
  }
  EXPECT_LT(two, 0.6 * one);
  EXPECT_LT(two, 0.008) << "m";
}

/// An open hand whose palm or back is tilted by so much from straight at the camera, and how networks see it.
struct OpenHand {
  HandView view;
  PosedHand truth;
};

OpenHand open_hand(Random& random, double tilt, double breadth) {
  OpenHand out;
  PosedHand& hand = out.truth;
  hand.hand = random.below(2);
  for (double& bend : hand.flexion) bend = random.uniform(0, 0.15);
  Mat3 upright;  // fingers up
  upright << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  const double turned = random.below(2) ? 0 : 3.14159265, about = random.uniform(0, 6.28);
  hand.camera_wrist.q = (Quat(Eigen::AngleAxisd(random.uniform(-0.4, 0.4), Vec3::UnitZ())) *
                         Eigen::AngleAxisd(tilt, Vec3(std::cos(about), std::sin(about), 0)) *
                         Eigen::AngleAxisd(turned, Vec3::UnitY()) * Quat(upright))
                            .normalized();
  const double depth = random.uniform(0.3, 0.7);
  hand.camera_wrist.p = Vec3(random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), 1) * depth -
                        hand.camera_wrist.q * Vec3(0, 0, -0.09);
  out.view.lens = webcam();
  const auto points = points_of_hand(hand.hand, hand.flexion);
  const double typical_residual = 0.015 * out.view.lens.fx * 0.19 / depth;
  HandDepths depths{};
  for (std::size_t k = 0; k < hand_points; ++k) {
    const Vec3 seen = hand.camera_wrist * Vec3(breadth * points[k].x(), points[k].y(), points[k].z());
    out.view.points[k] = out.view.lens.project(seen) +
                         typical_residual * Vec2(random.uniform(-1.7, 1.7), random.uniform(-1.7, 1.7));
    depths[k] = out.view.lens.fx * (seen.z() - hand.camera_wrist.p.z()) / depth;
  }
  out.view.depths = depths;
  return out;
}

/// What a first sight of many open hands gives.
struct FirstSights {
  int shown = 0, sure = 0, wrong = 0;  // wrong: sure, and turned by 40° or more from the truth
  std::vector<double> turns;           // rad, of sure ones

  double median_turn() {
    std::sort(turns.begin(), turns.end());
    return turns.empty() ? 1e9 : turns[turns.size() / 2];
  }
};

FirstSights first_sights(double tilt, bool with_depths, int hands) {
  FirstSights out;
  Random random(39);  // the seed
  for (int k = 0; k < hands; ++k) {
    OpenHand open = open_hand(random, tilt, random.uniform(0.84, 1.02));
    if (!with_depths) open.view.depths.reset();
    const auto fit = fit_hand({&open.view, 1}, {open.truth.hand, 1}, std::nullopt);
    ++out.shown;
    if (!fit || !fit->sure) continue;
    ++out.sure;
    out.turns.push_back(fit->wrist.q.angularDistance(open.truth.camera_wrist.q));
    out.wrong += out.turns.back() > 0.7;
  }
  return out;
}

// People's hands are slimmer than ours, more or less: held straight at the camera they look like ours turned
// to either side.
TEST(HandFit, ReportsAnOpenHandHeldStraightAtTheCamera) {
  for (const bool with_depths : {false, true}) {
    FirstSights found = first_sights(0, with_depths, 100);
    EXPECT_EQ(found.sure, found.shown);
    EXPECT_LE(found.wrong, 2);
    EXPECT_LT(found.median_turn(), 0.3) << "rad";
  }
}

TEST(HandFit, SeldomTurnsATiltedHandToTheWrongSide) {
  for (const double tilt : {0.3, 0.6, 0.9}) {
    FirstSights by_points = first_sights(tilt, false, 40), by_depths = first_sights(tilt, true, 40);
    SCOPED_TRACE(testing::Message() << "tilt " << tilt << " rad; wrong " << by_points.wrong << ", by depths "
                                    << by_depths.wrong);
    EXPECT_LE(by_points.wrong, 2);
    EXPECT_LE(by_depths.wrong, std::min(by_points.wrong, 1));
    EXPECT_LT(by_depths.median_turn(), 0.3) << "rad";
  }
}

TEST(HandFit, IsUnsureOfPointsThatAreNoHand) {
  Random random(4);
  int sure = 0;
  for (int k = 0; k < 200; ++k) {
    HandView view{{}, webcam(), {}};
    for (Vec2& p : view.points) p = {random.uniform(0, 640), random.uniform(0, 480)};
    const auto fit = fit_hand({&view, 1}, {random.below(2), 1}, std::nullopt);
    sure += fit && fit->sure;
  }
  EXPECT_LE(sure, 2);
}

TEST(HandFit, StandsPointsThatAreNoNumbersOrAllOne) {
  HandView view{{}, webcam(), {}};
  for (Vec2& p : view.points) p = {320, 240};
  for (const bool nan : {false, true}) {
    if (nan) view.points[7].x() = std::nan("");
    const auto fit = fit_hand({&view, 1}, {}, std::nullopt);
    EXPECT_FALSE(fit && fit->sure);
  }
  EXPECT_FALSE(fit_hand({}, {}, std::nullopt));
}

TEST(HandFit, LeftHandsPointsAreTheMirrorOfRightOnes) {
  const std::array<double, fingers> flexion = {0.3, 0.9, 0.1, 0.6, 1.0};
  const auto left = points_of_hand(left_hand, flexion), right = points_of_hand(right_hand, flexion);
  for (std::size_t k = 0; k < hand_points; ++k)
    EXPECT_LT((left[k].cwiseProduct(Vec3(-1, 1, 1)) - right[k]).norm(), 1e-12) << k;
}

}  // namespace
}  // namespace prosector
