// A tracked fingertip that is drawn along the text of a panel.

#include "client/app/desk/panel_finger.h"

#include <gtest/gtest.h>

#include "client/view/panel_view.h"
#include "common/hand.h"
#include "common/panel.h"

namespace prosector {
namespace {

class AFingerAtThePanel : public testing::Test {
 protected:
  PanelFinger finger;
  Panel panel;
  static constexpr std::size_t hidden = 20;
  static constexpr double middle = (panel_info.bottom + panel_head_bottom) / 2;

  void SetUp() override {
    panel.body = 3;
    panel.pose = {{0.2, 1.3, -0.1}, Quat(Eigen::AngleAxisd(0.4, Vec3::UnitY()))};
  }
  /// Brings the index finger's tip to a place in the panel's frame.
  void bring(const Vec3& tip) {
    HandInput user;
    HandPose& hand = user.hands[right_hand];
    hand.tracked = true;
    const HandSegment& last = hand_segments(right_hand)[4];
    const Vec3 from_wrist = hand_pose(right_hand, hand.flexion)[4] * Vec3(0, 0, -last.length);
    hand.pose = panel.pose * Pose{tip - from_wrist, Quat::Identity()};
    finger.follow(panel, hidden, user);
  }
};

TEST_F(AFingerAtThePanel, TakesTheTextAlong) {
  bring({0, middle, 0.005});
  EXPECT_EQ(finger.line(), 0u);
  for (int k = 1; k <= 4; ++k) bring({0.01 * k, middle + k * scrolled_line / 2, 0.005});
  EXPECT_EQ(finger.line(), 2u) << "upwards by two lines: on by two";
  bring({0, middle + scrolled_line, 0.2});
  bring({0, middle + scrolled_line, 0.005});
  EXPECT_EQ(finger.line(), 2u) << "off the board nothing moves";
  bring({0, middle, 0.005});
  EXPECT_EQ(finger.line(), 1u);
}

TEST_F(AFingerAtThePanel, GoesNoFartherThanToTheEndsAndBeginsAnewOnAnotherPart) {
  for (int k = 0; k < 40; ++k)
    for (const double y : {-1.0, 1.0}) {
      bring({0, middle, 0.2});
      bring({0, middle + y * scrolled_line * (y < 0 ? 0.9 : 0), 0});
      bring({0, middle + y * scrolled_line * 0.9, 0});
    }
  EXPECT_LE(finger.line(), hidden);
  EXPECT_GT(finger.line(), hidden / 2);
  panel.body = 4;
  bring({0, middle, 0.2});
  EXPECT_EQ(finger.line(), 0u);
}

TEST_F(AFingerAtThePanel, MovesNothingBesideTheText) {
  for (const Vec3& at : {Vec3(0, panel_info.bottom - 0.02, 0.005), Vec3(0, panel_head_bottom + 0.01, 0.005),
                         Vec3(panel_width, middle, 0.005), Vec3(0, middle, 0.05)}) {
    for (int k = 0; k < 5; ++k) bring(at + Vec3(0, 0.001 * k, 0));
    EXPECT_EQ(finger.line(), 0u) << at.transpose();
  }
}

}  // namespace
}  // namespace prosector
