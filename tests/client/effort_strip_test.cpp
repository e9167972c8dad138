// The strip below a panel: where its notches are, and what it tells.

#include "client/view/effort_strip.h"

#include <gtest/gtest.h>

namespace prosector {
namespace {

Panel some_panel() {
  Panel panel;
  panel.open = true;
  panel.pose = {{0.2, 1.3, -0.1}, Quat(Eigen::AngleAxisd(0.7, Vec3::UnitY()))};
  return panel;
}

/// Looks straight at a place in the panel's frame.
Ray at(const Panel& panel, const Vec3& place) {
  return {panel.pose * (place + Vec3(0, 0, 0.5)), panel.pose.q * -Vec3::UnitZ()};
}

TEST(EffortStrip, IsMetWhereItsNotchesAre) {
  const Panel panel = some_panel();
  for (std::uint32_t steps = 0; steps <= max_steps_down; ++steps)
    EXPECT_EQ(picked_effort(at(panel, effort_notch(steps)), panel), steps);
  EXPECT_EQ(picked_effort(at(panel, {-panel_width / 2 + 0.001, strip_y, 0}), panel), 0u);
  EXPECT_EQ(picked_effort(at(panel, {panel_width / 2 - 0.001, strip_y, 0}), panel), max_steps_down);
}

TEST(EffortStrip, IsNotMetBesideItOrFromBehind) {
  const Panel panel = some_panel();
  EXPECT_FALSE(picked_effort(at(panel, {0, 0, 0}), panel)) << "the panel's board";
  EXPECT_FALSE(picked_effort(at(panel, {0, strip_y - strip_height, 0}), panel));
  EXPECT_FALSE(picked_effort(at(panel, {panel_width, strip_y, 0}), panel));
  Ray behind = at(panel, effort_notch(1));
  behind.from = panel.pose * (effort_notch(1) - Vec3(0, 0, 0.5));
  behind.along = -behind.along;
  EXPECT_FALSE(picked_effort(behind, panel));
}

TEST(EffortStrip, DoesNotCoverTheBoard) {
  EXPECT_LT(strip_y + strip_height / 2, -panel_height / 2);
}

TEST(EffortStrip, TellsCostAndErrorWhereItIsKnown) {
  EXPECT_EQ(in_words(ShownEffort{.steps_down = 0, .tick_ms = 4.12, .error = 0.021}),
            "now 4.1 ms per tick, error about 2.1 %");
  EXPECT_EQ(in_words(ShownEffort{.steps_down = 2, .tick_ms = 4.12, .error = -1}),
            "now 4.1 ms per tick, error unknown");
}

}  // namespace
}  // namespace prosector
