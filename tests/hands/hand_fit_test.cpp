// The hand laid through points: exact where they are exact, unsure where they are none of a hand.
#include "drivers/camera/hands/hand_fit.h"

#include <gtest/gtest.h>

#include "tests/hands/hand_pictures.h"

namespace prosector {
namespace {

HandView view_of(const HandScene& scene, const BentHand& hand) {
  return {true_points(scene, hand), scene.lens, scene.camera_rig};
}

/// Shows one hand of any side and size, without pictures.
HandScene shown(Random& random) {
  HandScene scene;
  scene.lens = webcam();
  BentHand hand = random_hand(random, 0.3, 0.8);
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
    const BentHand& hand = scene.hands[0];
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
    const BentHand& hand = scene.hands[0];
    HandFit before{hand.camera_wrist, hand.flexion, 0, true};
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
    const BentHand hand = scene.hands[0];
    std::vector<HandView> views;
    for (const double x : {0.0, -0.12}) {
      scene.camera_rig = {Vec3(x, 0, 0), Quat::Identity()};
      views.push_back(view_of(scene, hand));
      for (Vec2& p : views.back().points) p += Vec2(random.uniform(-3, 3), random.uniform(-3, 3));
    }
    const HandFit before{hand.camera_wrist, hand.flexion, 0, true};
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
