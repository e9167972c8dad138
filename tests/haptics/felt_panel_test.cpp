// What an arm's finger is told of a panel.
#include <gtest/gtest.h>

#include "common/index_tip.h"
#include "common/panel.h"
#include "server/haptics/felt_panel.h"
#include "server/physics/mechanics/panel/panel_motion.h"

namespace prosector {
namespace {

/// A panel that stands somewhere askew.
Panel standing() {
  Panel panel;
  panel.open = true;
  panel.body = 3;
  panel.pose = {Vec3(0.1, 1.2, -0.3), Quat(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()))};
  return panel;
}

/// A hand whose index finger's tip ends so far over that place of the board, m; it points at the board.
HandPose pointing_at(const Panel& panel, double x, double y, double over) {
  HandPose hand;
  hand.flexion = {1, 0, 1, 1, 1};
  hand.pose.q = panel.pose.q;
  const double radius = hand_segments(right_hand)[index_end].radius;
  hand.pose.p = panel.pose * Vec3(x, y, over + radius) - index_tip(right_hand, hand);
  return hand;
}

/// N, on the hand, out of the board, where it is.
double force_on(const Panel& panel, const HandPose& hand) {
  double out = 0;
  for (const ContactPlane& plane : panel_planes(panel, right_hand, hand)) {
    EXPECT_NEAR(plane.normal.dot(panel.pose.q * Vec3::UnitZ()), 1, 1e-12);
    EXPECT_EQ(plane.body, 3u);
    out += std::max(0., plane.force.dot(plane.normal) +
                            plane.stiffness * (plane.point - hand.pose * plane.arm).dot(plane.normal));
  }
  return out;
}

TEST(FeltPanel, AButtonGivesWayByItsSpringUntilItIsHome) {
  const Panel panel = standing();
  for (const ControlDesc& control : panel_controls) {
    if (control.kind != ControlKind::button) continue;
    const auto at = [&](double pressed) {
      return force_on(panel, pointing_at(panel, control.x, control.y, control.height - pressed));
    };
    EXPECT_EQ(at(-0.001), 0) << "not yet";
    EXPECT_NEAR(at(0.003), 0.003 * panel::button_stiffness, 1e-9);
    const double home = at(control.travel), beyond = at(control.travel + 0.0005);
    EXPECT_NEAR(home, control.travel * panel::button_stiffness, 1e-9);
    EXPECT_GT((beyond - home) / 0.0005, 4 * panel::button_stiffness) << "the stop is the click";
  }
}

TEST(FeltPanel, TheBoardStopsTheFinger) {
  const Panel panel = standing();
  EXPECT_EQ(force_on(panel, pointing_at(panel, 0, 0.1, 0.001)), 0);
  EXPECT_GT(force_on(panel, pointing_at(panel, 0, 0.1, -0.001)), 1);
}

TEST(FeltPanel, IsToldBeforeItIsMetAndNowhereElse) {
  const Panel panel = standing();
  EXPECT_EQ(panel_planes(panel, right_hand, pointing_at(panel, 0, 0.1, 0.02)).size(), 1u);
  EXPECT_TRUE(panel_planes(panel, right_hand, pointing_at(panel, 0, 0.1, 0.05)).empty());
  EXPECT_TRUE(panel_planes(panel, right_hand, pointing_at(panel, 0.2, 0, 0.01)).empty()) << "beside it";
  EXPECT_TRUE(panel_planes(panel, right_hand, pointing_at(panel, 0, 0, -0.1)).empty()) << "behind it";
  Panel shut = panel;
  shut.open = false;
  EXPECT_TRUE(panel_planes(shut, right_hand, pointing_at(panel, 0, 0.1, 0.01)).empty());
}

TEST(FeltPanel, TheKnobIsWhereItStands) {
  Panel panel = standing();
  const auto slider = static_cast<std::size_t>(PanelControl::stiffness);
  const ControlDesc& control = panel_controls[slider];
  for (const double position : {0.1, 0.9}) {
    panel.controls[slider].position = position;
    const double x = control_face(control, position).x();
    EXPECT_GT(force_on(panel, pointing_at(panel, x, control.y, control.height - 0.001)), 1);
    EXPECT_EQ(force_on(panel, pointing_at(panel, -x, control.y, control.height - 0.001)), 0);
  }
}

}  // namespace
}  // namespace prosector
