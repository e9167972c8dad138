// A hand at the desk: over what the pointer is at, in, and drawn along the picture.

#include "client/app/desk/desk_hand.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace prosector {
namespace {

constexpr double frame = 0.02;  // s

class HandAtTheDesk : public testing::Test {
 protected:
  DeskHand hand;
  HandGuide guide;

  void SetUp() override {
    guide.pointer = {{0, 1.5, 1}, Vec3(0, -0.5, -1).normalized()};
    guide.back = -guide.pointer.along;
    hand.begin(guide.pointer, 0.7);
  }
  /// Goes on; the physical hand is where it is to be.
  void go_on(double seconds) {
    for (double t = 0; t < seconds; t += frame) {
      guide.physical = hand.pose();
      hand.advance(guide, frame);
    }
  }
  double along() const { return (hand.fingertips() - guide.pointer.from).dot(guide.pointer.along); }
  double beside() const {
    return (hand.fingertips() - guide.pointer.from - along() * guide.pointer.along).norm();
  }
};

TEST_F(HandAtTheDesk, HoversAboveTheSurfaceAndTheWheelSaysHowHigh) {
  guide.surface = 1.0;
  go_on(1);
  EXPECT_NEAR(along(), 1.0 - first_hover, 1e-9);
  EXPECT_LT(beside(), 1e-9);
  hand.reach(-0.05);
  go_on(1);
  EXPECT_NEAR(along(), 1.0 - first_hover - 0.05, 1e-9);
  guide.surface = 0.8;
  go_on(1);
  EXPECT_NEAR(along(), 0.8 - first_hover - 0.05, 1e-9) << "kept over another surface";
  hand.reach(10);
  go_on(1);
  EXPECT_GT(along(), 0.8) << "pressed in";
  EXPECT_LT(along(), 0.85);
}

TEST_F(HandAtTheDesk, StaysClearOfWhatIsBesideThePointer) {
  guide.surface = 1.0;
  guide.gap = [](const Vec3& place) { return std::optional(place.x() > 0.02 ? -0.03 : 1.0); };
  go_on(1);
  EXPECT_NEAR(along(), 1.0 - first_hover - 0.055, 1e-9) << "3 cm, and 2.5 cm clear of it";
  hand.press();
  go_on(0.3);
  EXPECT_NEAR(along(), 0.985, 1e-6) << "in reach of what is hard";
  hand.let_go();
  hand.reach(0.03);
  go_on(1);
  EXPECT_NEAR(along(), 1.0 - first_hover + 0.03, 1e-6) << "so low the wheel wants it to touch";
}

TEST_F(HandAtTheDesk, KeepsItsDepthWhereThereIsNoSurface) {
  guide.surface = 1.0;
  go_on(1);
  const double kept = along();
  guide.surface.reset();
  go_on(0.5);
  EXPECT_NEAR(along(), kept, 1e-9);
  guide.pointer.along = Vec3(0.3, -0.4, -1).normalized();
  go_on(1);
  EXPECT_NEAR(along(), kept, 1e-9);
  hand.reach(0.1);
  go_on(1);
  EXPECT_NEAR(along(), kept + 0.1, 1e-9);
}

TEST_F(HandAtTheDesk, TheButtonBringsItInAndGrasps) {
  guide.surface = 1.0;
  guide.soft = true;
  go_on(1);
  hand.press();
  EXPECT_TRUE(hand.take_wishes().empty()) << "not in yet";
  go_on(0.3);
  EXPECT_NEAR(along(), 1.008, 1e-6) << "into what gives way";
  EXPECT_EQ(hand.take_wishes(), std::vector<HandRequest>{HandRequest::grasp});
  go_on(0.3);
  EXPECT_GT(hand.flexion(), 0.8);
  hand.let_go();
  EXPECT_EQ(hand.take_wishes(), std::vector<HandRequest>{HandRequest::release});
  go_on(0.3);
  EXPECT_NEAR(along(), 1.0 - first_hover, 1e-9);
  EXPECT_LT(hand.flexion(), 0.2);
}

TEST_F(HandAtTheDesk, AClickIsTooShortToGrasp) {
  guide.surface = 1.0;
  go_on(1);
  hand.press();
  go_on(0.08);
  hand.let_go();
  go_on(1);
  EXPECT_TRUE(hand.take_wishes().empty());
}

TEST_F(HandAtTheDesk, WaitsForThePhysicalHandButNotForEver) {
  guide.surface = 1.0;
  go_on(1);
  hand.press();
  guide.physical->p += Vec3(0.2, 0, 0);
  for (double t = 0; t < 0.4; t += frame) hand.advance(guide, frame);
  EXPECT_TRUE(hand.take_wishes().empty());
  for (double t = 0; t < 0.2; t += frame) hand.advance(guide, frame);
  EXPECT_EQ(hand.take_wishes().size(), 1u);
}

/// On a busy machine the physical hand's news are late: while it comes nearer, the hand doesn't close.
TEST_F(HandAtTheDesk, WaitsLongerForAPhysicalHandThatIsOnItsWay) {
  guide.surface = 1.0;
  go_on(1);
  hand.press();
  for (double t = 0; t < 1.6; t += frame) {
    const double behind = std::max(0.0, 0.2 - 0.1 * std::floor(t / 0.4) * 0.4);
    guide.physical->p = hand.pose().p + Vec3(behind, 0, 0);
    hand.advance(guide, frame);
  }
  EXPECT_TRUE(hand.take_wishes().empty());
  go_on(0.1);
  EXPECT_EQ(hand.take_wishes().size(), 1u) << "it is there";
}

/// Tissue keeps the physical hand behind it. Without this the hand would press there for as long as it
/// hovers.
TEST_F(HandAtTheDesk, IsWithdrawnWhereItHoversAndThePhysicalHandIsStuck) {
  guide.surface = 1.0;
  go_on(1);
  guide.physical->p += Vec3(0, 0, -0.2);
  double seconds = 0;
  for (; seconds < 3 && !hand.is_withdrawn(); seconds += frame) hand.advance(guide, frame);
  EXPECT_NEAR(seconds, 1, 0.1);
  for (double t = 0; t < 2; t += frame) hand.advance(guide, frame);
  EXPECT_TRUE(hand.is_withdrawn()) << "the server still has the physical hand";
  guide.physical.reset();
  hand.advance(guide, frame);
  EXPECT_FALSE(hand.is_withdrawn());
  go_on(2);
  EXPECT_FALSE(hand.is_withdrawn()) << "it is where it is wanted";
}

TEST_F(HandAtTheDesk, IsNotWithdrawnWhileItIsOnItsWayPressesOrTimeStands) {
  guide.surface = 1.0;
  go_on(1);
  const Pose far{hand.pose().p - Vec3(0, 0, 0.5), hand.pose().q};
  guide.physical = far;
  for (double t = 0; t < 3; t += frame) {
    guide.physical->p.z() = far.p.z() + 0.1 * t;
    hand.advance(guide, frame);
    ASSERT_FALSE(hand.is_withdrawn()) << "slowly on its way";
  }
  guide.is_paused = true;
  for (double t = 0; t < 3; t += frame) hand.advance(guide, frame);
  EXPECT_FALSE(hand.is_withdrawn());
  guide.is_paused = false;
  guide.physical = far;
  for (double t = 0; t < 1.5; t += frame) hand.advance(guide, frame);
  ASSERT_TRUE(hand.is_withdrawn());
  hand.press();
  hand.advance(guide, frame);
  EXPECT_FALSE(hand.is_withdrawn());
  hand.let_go();
  hand.take_wishes();
  hand.reach(10);  // its wheel presses it in
  for (double t = 0; t < 3; t += frame) hand.advance(guide, frame);
  EXPECT_FALSE(hand.is_withdrawn()) << "it is to press";
}

TEST_F(HandAtTheDesk, WhatItHoldsIsDrawnParallelToThePictureAndPulledByTheWheel) {
  guide.surface = 1.0;
  go_on(1);
  hand.press();
  go_on(0.5);
  const Vec3 taken = hand.fingertips();
  guide.surface = 3;  // what is held is not in the pointer's way: it meets what is behind
  guide.pointer.along = Vec3(0.2, -0.4, -1).normalized();
  go_on(0.1);
  EXPECT_LT((hand.fingertips() - taken).norm(), 0.1) << "gently";
  go_on(1);
  const Vec3 drawn = hand.fingertips();
  EXPECT_GT((drawn - taken).norm(), 0.1);
  EXPECT_NEAR((drawn - taken).dot(guide.back), 0, 1e-9);
  EXPECT_LT(beside(), 1e-9) << "under the pointer";
  const double depth = along();
  for (int k = 0; k < 5; ++k) hand.reach(-0.02);
  go_on(1);
  EXPECT_NEAR(along(), depth - 0.1, 1e-9);
}

TEST_F(HandAtTheDesk, AnInstrumentHoversByItsTip) {
  guide.surface = 1.0;
  go_on(1);
  hand.press();
  go_on(0.3);
  const Pose before = hand.pose();
  guide.tip = Vec3(0.02, -0.01, -0.36);
  guide.physical = hand.pose();
  hand.advance(guide, frame);
  EXPECT_LT((hand.pose().p - before.p).norm(), 2.4 * frame) << "no jump";
  go_on(2);
  const auto tip = [&] { return Vec3(hand.pose() * *guide.tip); };
  EXPECT_LT((tip() - guide.pointer.from - (1.0 - first_hover) * guide.pointer.along).norm(), 1e-6);
  hand.reach(0.06);
  go_on(1);
  EXPECT_NEAR((tip() - guide.pointer.from).dot(guide.pointer.along), 1.02, 1e-6) << "2 cm into it";
  guide.tip.reset();
  hand.let_go();
  go_on(2);
  EXPECT_NEAR(along(), 1.0 - first_hover, 1e-6);
}

TEST_F(HandAtTheDesk, ComesFromBelowThePictureButNotFromBelowATable) {
  const auto lift = [&] { return std::asin((hand.pose().q * -Vec3::UnitZ()).y()); };
  guide.surface = 1.0;
  guide.pitch = 0;
  guide.level = 0;
  go_on(1);
  EXPECT_GT(lift(), 0.3) << "a wall, seen level";
  guide.pitch = 0.6;
  guide.level = 1;
  go_on(1);
  EXPECT_LT(lift(), -0.2) << "a table: the wrist is above it";
  hand.press();
  go_on(0.3);
  const double held = lift();
  guide.pitch = 1.5;
  go_on(1);
  EXPECT_NEAR(lift(), held, 1e-9) << "what is held isn't turned";
  hand.let_go();
  go_on(1);
  EXPECT_NEAR(lift(), -0.6, 1e-9);
}

TEST_F(HandAtTheDesk, BendsUpAndDownHoweverItIsRolled) {
  const Quat level = hand.pose().q;
  for (const double roll : {0.0, 0.8, 0.8}) {
    hand.turn(roll, 0);
    const auto ahead = [&] { return Vec3(hand.pose().q * level.conjugate() * -Vec3::UnitZ()); };
    EXPECT_LT((ahead() + Vec3::UnitZ()).norm(), 1e-9);
    hand.turn(0, -0.3);
    EXPECT_LT((ahead() - Vec3(0, -std::sin(0.3), -std::cos(0.3))).norm(), 1e-9) << roll;
    hand.turn(0, 0.3);
  }
}

/// A hand at the desk that took up a blade.
class BladeAtTheDesk : public HandAtTheDesk {
 protected:
  const BladeFrame blade{{0.01, -0.01, -0.3}, -Vec3::UnitZ(), -Vec3::UnitX(), 0.04};

  void SetUp() override {
    HandAtTheDesk::SetUp();
    guide.surface = 1.0;
    guide.at_blade = true;
    go_on(1);
    hand.press();
    go_on(0.3);
    ASSERT_EQ(hand.take_wishes(), std::vector<HandRequest>{HandRequest::grasp});
  }
  void take_up() {
    guide.blade = blade;
    guide.tip = blade.tip;
    guide.at_blade = false;
    guide.find = [](const Ray& ray, std::optional<BodyId>) { return std::optional(floor_below(ray)); };
    go_on(0.1);
    hand.let_go();
    go_on(1);
  }
  static Picked floor_below(const Ray& ray) {
    const double distance = -ray.from.y() / ray.along.y();
    return {{distance, ray.from + distance * ray.along, Vec3::UnitY()}, 5};
  }
  void point_at_tissue(double x) {
    guide.pointer.along = (Vec3(x, 0, -1) - guide.pointer.from).normalized();
    guide.tissue = floor_below(guide.pointer);
    guide.surface = guide.tissue->distance;
  }
};

TEST_F(BladeAtTheDesk, StaysInTheHandUntilAClickBesideTissue) {
  hand.let_go();
  EXPECT_TRUE(hand.take_wishes().empty()) << "the server has not told yet what it is";
  take_up();
  EXPECT_TRUE(hand.is_closed());
  EXPECT_TRUE(hand.take_wishes().empty());
  EXPECT_EQ(hand.cut_depth(), std::optional(first_cut_depth));
  hand.press();
  go_on(1);
  hand.let_go();
  EXPECT_TRUE(hand.take_wishes().empty()) << "held, not clicked";
  hand.press();
  go_on(0.2);
  hand.let_go();
  EXPECT_EQ(hand.take_wishes(), std::vector<HandRequest>{HandRequest::release});
  EXPECT_FALSE(hand.cut_depth());
}

TEST_F(BladeAtTheDesk, IsLetGoWhereTheServerSaysThatTheHandHoldsNone) {
  hand.let_go();
  go_on(1);
  EXPECT_EQ(hand.take_wishes(), std::vector<HandRequest>{HandRequest::release});
  EXPECT_FALSE(hand.is_closed());
}

TEST_F(BladeAtTheDesk, OpensWhenTheBladeIsTakenOutOfIt) {
  take_up();
  guide.blade.reset();
  guide.tip.reset();
  go_on(1);
  EXPECT_FALSE(hand.is_closed());
}

TEST_F(BladeAtTheDesk, CutsWhereTheButtonDrawsIt) {
  take_up();
  point_at_tissue(0);
  go_on(1);
  hand.press();
  go_on(0.5);
  hand.let_go();
  go_on(0.5);
  EXPECT_TRUE(hand.take_wishes().empty()) << "a click on tissue puts nothing down";
  hand.press();
  hand.reach(0.05);
  double deepest = 0;
  for (int k = 0; k <= 100; ++k) {
    point_at_tissue(0.001 * k);
    go_on(0.02);
    deepest = std::min(deepest, (hand.pose() * blade.tip).y());
  }
  hand.let_go();
  for (int k = 0; k < 100; ++k) {
    go_on(0.02);
    deepest = std::min(deepest, (hand.pose() * blade.tip).y());
  }
  EXPECT_NEAR(deepest, -first_cut_depth - 0.005, 1e-3) << "five notches of the wheel deeper";
  EXPECT_GT((hand.pose() * blade.tip).y(), 0.01) << "out again";
  EXPECT_TRUE(hand.is_closed());
}

TEST_F(HandAtTheDesk, NeverJumps) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> anywhere(-1, 1);
  Vec3 last = hand.fingertips();
  for (int k = 0; k < 3000; ++k) {
    switch (random() % 6) {
      case 0:
        guide.pointer.along = Vec3(anywhere(random), anywhere(random), -1).normalized();
        break;
      case 1:
        guide.surface = 2 + 2 * anywhere(random);
        break;
      case 2:
        guide.surface.reset();
        break;
      case 3:
        hand.reach(anywhere(random));
        break;
      case 4:
        hand.press();
        break;
      default:
        hand.let_go();
    }
    guide.physical = hand.pose();
    hand.advance(guide, frame);
    ASSERT_TRUE(is_finite(hand.pose()));
    ASSERT_LE((hand.fingertips() - last).norm(), fastest_hand * frame + 1e-9);
    last = hand.fingertips();
  }
}

}  // namespace
}  // namespace prosector
