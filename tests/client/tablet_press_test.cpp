// A bare finger before one camera works a tablet, though its depth is seen badly.

#include "client/app/user/tablet_press.h"

#include <gtest/gtest.h>

#include <random>

#include "common/ids.h"
#include "common/index_tip.h"
#include "common/panel.h"

namespace prosector {
namespace {

constexpr std::int64_t film_ns = 33'000'000, slow_ns = 400'000'000;  // from picture to picture
const std::array<double, fingers> pointing = {0.6, 0.1, 0.8, 0.85, 0.8}, flat = {0.1, 0.1, 0.1, 0.1, 0.1},
                                  fist = {0.8, 0.9, 0.9, 0.9, 0.9};

/// What a camera that looks at a tilted tablet makes of a hand: sideways right to some millimetres, in depth
/// to some centimetres, which drift.
class SeenHand {
 public:
  explicit SeenHand(std::uint32_t seed, std::int64_t picture_ns = film_ns)
      : random_(seed), picture_ns_(picture_ns) {}

  const Pose tablet{{0.1, 1.2, -0.2}, Quat(Eigen::AngleAxisd(-0.5, Vec3::UnitX()))};
  const Vec3 eye{0.15, 1.5, 0.35};

  /// Shows the next picture: the tip's true place in the panel's frame. Returns the tip's place, there, of
  /// the hand that works the tablet.
  Vec3 show(const Vec3& tip, const std::array<double, fingers>& bends) {
    std::normal_distribution<double> noise;
    drift_ = 0.95 * drift_ + 0.02 * std::sqrt(1 - 0.95 * 0.95) * noise(random_);
    HandPose hand;
    hand.tracked = true;
    for (std::size_t f = 0; f < fingers; ++f)
      hand.flexion[f] = std::clamp(bends[f] + 0.08 * noise(random_), 0.0, 1.0);
    const Vec3 truly = tablet * tip, along = (truly - eye).normalized();
    const Vec3 seen = truly + drift_ * along + 0.001 * Vec3(noise(random_), noise(random_), noise(random_));
    hand.pose.q = tablet.q * Quat(Eigen::AngleAxisd(-0.8, Vec3::UnitX()));
    hand.pose.p += seen - index_tip(right_hand, hand);
    now_ += picture_ns_;
    worked_ = press_.follow(right_hand, hand, tablet, eye, now_);
    moved_ = (worked_.pose.p - hand.pose.p).norm();
    return tablet.inverse() * index_tip(right_hand, worked_);
  }
  /// Tells whether the hand's finger is so deep that it presses a button home.
  static bool presses(const Vec3& tip) {
    return tip.z() - hand_segments(right_hand)[index_end].radius < button_height - 0.8 * button_travel;
  }
  void vanish() { press_.lose(right_hand); }
  double moved() const { return moved_; }  // m, against what is seen
  /// Returns the height of the lowest fingertip over the controls, m.
  double lowest_tip() const {
    const Pose wrist = tablet.inverse() * worked_.pose;
    double lowest = 1;
    const auto poses = hand_pose(right_hand, worked_.flexion);
    for (const std::size_t tip : {1u, 4u, 7u, 10u, 13u}) {
      const HandSegment& end = hand_segments(right_hand)[tip];
      const Vec3 at = wrist * (poses[tip] * Vec3(0, 0, -end.length));
      const bool is_over = std::abs(at.x()) < 0.14 && at.y() < 0.05 && at.y() > -0.115;
      if (is_over) lowest = std::min(lowest, at.z() - end.radius);
    }
    return lowest;
  }

 private:
  std::mt19937 random_;
  TabletPress press_;
  HandPose worked_;
  double drift_ = 0, moved_ = 0;
  std::int64_t picture_ns_, now_ = 1'000'000'000;
};

Vec3 over_middle(std::size_t control, double height) {
  return {panel_controls[control].x, panel_controls[control].y, height};
}

TEST(TabletPress, AFingerThatStaysAtAButtonPressesItAndNoOther) {
  for (std::size_t k = 0; k < 5; ++k)
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
      SeenHand hand(seed);
      for (int i = 0; i < 10; ++i) hand.show({0.0, 0.12, 0.03}, pointing);
      int pressed = 0;
      for (int i = 0; i < 40; ++i) {
        const Vec3 tip = hand.show(over_middle(k, 0.008), pointing);
        if (SeenHand::presses(tip)) ++pressed;
        EXPECT_LT((tip - over_middle(k, tip.z())).head<2>().norm(), 0.02) << "it is where it is seen";
      }
      EXPECT_GE(pressed, 20) << panel_controls[k].label << ", " << seed;
      int after = 0;
      for (int i = 0; i < 20; ++i)
        if (SeenHand::presses(hand.show({0, 0.1, 0.02}, pointing))) ++after;
      EXPECT_EQ(after, 0);
    }
}

TEST(TabletPress, AFingerPressesWherePicturesComeSlowly) {
  for (std::size_t k = 0; k < 5; ++k)
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
      SeenHand hand(seed, slow_ns);
      int pictures = 1;
      while (!SeenHand::presses(hand.show(over_middle(k, 0.008), pointing)) && pictures < 20) ++pictures;
      EXPECT_LE(pictures, 4) << panel_controls[k].label << ", " << seed;
    }
}

TEST(TabletPress, AFingerThatWasOutOfSightStaysForLongEnoughAgain) {
  SeenHand hand(5);
  const Vec3 at = over_middle(3, 0.008);
  for (int i = 0; i < 25; ++i) hand.show(at, pointing);
  EXPECT_TRUE(SeenHand::presses(hand.show(at, pointing)));
  hand.vanish();
  for (int i = 0; i < 14; ++i) EXPECT_FALSE(SeenHand::presses(hand.show(at, pointing))) << i;
}

TEST(TabletPress, WhatDoesNotPointIsKeptOffTheBoard) {
  for (const auto& bends : {flat, fist})
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
      SeenHand hand(seed);
      for (int i = 0; i < 300; ++i) {
        hand.show(over_middle(seed % 5, 0.01), bends);
        EXPECT_GT(hand.lowest_tip(), 0.029) << seed;
      }
    }
}

TEST(TabletPress, AFingerThatPassesOverThePanelPressesNothing) {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> any(-0.09, 0.09);
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    SeenHand hand(seed);
    const Vec3 from(any(random), any(random), 0.02), to(any(random), any(random), 0.02);
    const int pictures = static_cast<int>((to - from).norm() / 0.06 * 30) + 1;  // 6 cm/s
    for (int i = 0; i <= pictures; ++i) {
      const double share = static_cast<double>(i) / pictures;
      EXPECT_FALSE(SeenHand::presses(hand.show(from + share * (to - from), pointing))) << seed;
    }
  }
}

TEST(TabletPress, TheSliderIsTakenAlong) {
  SeenHand hand(3);
  const auto slider = static_cast<std::size_t>(PanelControl::stiffness);
  for (int i = 0; i < 25; ++i) hand.show(over_middle(slider, 0.016), pointing);
  for (int i = 0; i < 40; ++i) {
    const Vec3 tip = hand.show(over_middle(slider, 0.016) + Vec3(0.002 * i, 0, 0), pointing);
    EXPECT_NEAR(tip.z() - hand_segments(right_hand)[index_end].radius, knob_height, 0.001);
    EXPECT_NEAR(tip.x(), 0.002 * i, 0.01);
  }
}

TEST(TabletPress, AFingerFarFromTheBoardStaysWhereItIsSeen) {
  SeenHand hand(4);
  for (const Vec3& tip : {Vec3(0, 0, 0.4), Vec3(0.3, 0, 0.02), Vec3(0, 0.3, 0.02), Vec3(0.5, 0, -0.3)})
    for (int i = 0; i < 40; ++i) {
      hand.show(tip, pointing);
      EXPECT_EQ(hand.moved(), 0);
    }
}

}  // namespace
}  // namespace prosector
