// Buttons and slider under fingers.

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "tests/panel/fingers.h"

namespace prosector::test {
namespace {

constexpr PanelControl slider = PanelControl::stiffness;

TEST(PanelTable, ControlsLieOnTheBoardAndApart) {
  for (std::size_t i = 0; i < panel_control_count; ++i) {
    const ControlDesc& a = panel_controls[i];
    EXPECT_EQ(index_of(a.control), i);
    const bool sliding = a.kind == ControlKind::slider;
    const double half_x = a.half_width + (sliding ? a.travel / 2 : 0);
    EXPECT_LE(std::abs(a.x) + half_x, panel_width / 2);
    EXPECT_LE(std::abs(a.y) + a.half_height, panel_height / 2);
    EXPECT_LT(a.y + a.half_height, panel_info.bottom);
    EXPECT_GT(control_face(a, 1).z(), 0);
    for (std::size_t k = 0; k < i; ++k) {
      const ControlDesc& b = panel_controls[k];
      const double other_x = b.half_width + (b.kind == ControlKind::slider ? b.travel / 2 : 0);
      EXPECT_TRUE(std::abs(a.x - b.x) >= half_x + other_x + 0.004 ||
                  std::abs(a.y - b.y) >= a.half_height + b.half_height + 0.004)
          << a.label << " and " << b.label;
    }
  }
}

TEST(PanelTable, StiffnessIsALogarithmicScale) {
  EXPECT_NEAR(stiffness_at(0), 0.25, 1e-12);
  EXPECT_NEAR(stiffness_at(0.5), 1, 1e-12);
  EXPECT_NEAR(stiffness_at(1), 4, 1e-12);
  for (double p = 0; p <= 1; p += 0.05) EXPECT_NEAR(position_of_stiffness(stiffness_at(p)), p, 1e-12);
}

class EachButton : public testing::TestWithParam<std::size_t> {
 protected:
  const ControlDesc& button() const { return panel_controls[GetParam()]; }
  Vec3 tip(double height) const { return {button().x, button().y, height}; }
};

TEST_P(EachButton, FollowsTheFingerAndSpringsBack) {
  const double face = button().height;
  const panel::MovedControls half =
      move_finger(at_rest(), tip(face + 0.02), tip(face - button().travel / 2), 20);
  EXPECT_NEAR(half.motions[GetParam()].position, 0.5, 0.15) << "pushed half way";
  EXPECT_TRUE(half.touched[GetParam()]);
  const panel::MovedControls home = move_finger(half.motions, tip(face - button().travel / 2), tip(0.001), 6);
  EXPECT_GT(home.motions[GetParam()].position, panel::home_position);
  for (std::size_t k = 0; k < panel_control_count; ++k) {
    if (k == GetParam()) continue;
    EXPECT_FALSE(home.touched[k]);
    EXPECT_EQ(home.motions[k].position, at_rest()[k].position);
  }
  const panel::ControlMotions soon = rest(home.motions, 9);
  EXPECT_LT(soon[GetParam()].position, 0.1) << "150 ms after";
  const panel::ControlMotions later = rest(soon, 60);
  EXPECT_EQ(later[GetParam()].position, 0);
  EXPECT_EQ(later[GetParam()].velocity, 0);
}

TEST_P(EachButton, StaysHomeUnderAFingerThatWentThrough) {
  panel::ControlMotions motions = move_finger(at_rest(), tip(0.03), tip(-0.04), 10).motions;
  for (int i = 0; i < 60; ++i) {
    motions = move_finger(motions, tip(-0.04), tip(-0.04), 1).motions;
    ASSERT_GT(motions[GetParam()].position, panel::home_position) << i;
  }
}

TEST_P(EachButton, HasNoOtherDirection) {
  // Along the board, against the cap's outer side.
  const ControlDesc& b = button();
  const double side = b.x < 0 ? -1 : 1, edge = b.x + side * b.half_width;
  const panel::MovedControls moved = move_finger(at_rest(), Vec3(edge + side * 0.012, b.y, 0.001),
                                                 Vec3(edge + side * 0.0075, b.y, 0.001), 10);
  EXPECT_LT(moved.motions[GetParam()].position, 0.35);
}

INSTANTIATE_TEST_SUITE_P(Panel, EachButton, testing::Range<std::size_t>(0, 5));

TEST(Slider, IsPushedFromItsSideAndStaysWhereItWasLeft) {
  const ControlDesc& knob = describe(slider);
  const Vec3 beside(control_face(knob, 0.5).x() - 0.03, knob.y, 0.002);
  const panel::MovedControls moved = move_finger(at_rest(), beside, beside + Vec3(0.06, 0, 0), 30);
  // The finger's ball touches the knob's edge: its middle is a radius and half a knob behind.
  const double expected = 0.5 + (0.03 + finger_radius + knob.half_width) / knob.travel;
  EXPECT_NEAR(moved.motions[index_of(slider)].position, expected, 0.02);
  EXPECT_TRUE(moved.touched[index_of(slider)]);
  const panel::ControlMotions left = rest(moved.motions, 10), later = rest(left, 300);
  EXPECT_EQ(later[index_of(slider)].position, left[index_of(slider)].position);
  EXPECT_EQ(later[index_of(slider)].velocity, 0);
}

TEST(Slider, GoesAlongUnderAFingerThatLiesOnIt) {
  const ControlDesc& knob = describe(slider);
  const Vec3 above(control_face(knob, 0.5).x(), knob.y, knob.height + 0.02), on = above - Vec3(0, 0, 0.022);
  const panel::MovedControls pressed = move_finger(at_rest(), above, on, 15);
  EXPECT_NEAR(pressed.motions[index_of(slider)].position, 0.5, 0.02) << "pressing alone moves nothing";
  const panel::MovedControls dragged = move_finger(pressed.motions, on, on - Vec3(0.05, 0, 0), 40);
  EXPECT_NEAR(dragged.motions[index_of(slider)].position, 0.5 - 0.05 / knob.travel, 0.05);
}

TEST(Slider, StopsAtBothEnds) {
  const ControlDesc& knob = describe(slider);
  for (const double side : {-1.0, 1.0}) {
    const Vec3 start(control_face(knob, 0.5).x() - side * 0.03, knob.y, 0.002);
    const panel::MovedControls moved = move_finger(at_rest(), start, start + Vec3(side * 0.25, 0, 0), 40);
    EXPECT_NEAR(moved.motions[index_of(slider)].position, side < 0 ? 0 : 1, 0.02);
  }
}

TEST(PanelMotion, RestsWithoutFingers) {
  const panel::ControlMotions before = at_rest(), after = rest(before, 100);
  for (std::size_t k = 0; k < panel_control_count; ++k) EXPECT_EQ(after[k].position, before[k].position);
}

/// Hands that jump, fly, and aren't numbers.
TEST(PanelMotion, StaysInItsRangeWhateverFingersDo) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> wide(-0.3, 0.3), narrow(-0.1, 0.1), unit(0, 1);
  const double nan = std::numeric_limits<double>::quiet_NaN(), huge = 1e300;
  for (const double h : {1.0 / 10000, 1.0 / 60, 1.0}) {
    panel::ControlMotions motions = at_rest();
    std::vector<panel::FingerSweep> sweeps(15);
    for (int i = 0; i < 150; ++i) {
      for (panel::FingerSweep& sweep : sweeps) {
        const auto random_finger = [&] {
          panel::Capsule c{Vec3(wide(random), wide(random), narrow(random)), {}, 0.004 + 0.01 * unit(random)};
          c.b = c.a + Vec3(narrow(random), narrow(random), narrow(random));
          if (unit(random) < 0.01) c.a.x() = nan;
          if (unit(random) < 0.01) c.b.y() = huge;
          if (unit(random) < 0.05) c.b = c.a;
          return c;
        };
        sweep = {unit(random) < 0.5 ? sweep.to : random_finger(), random_finger()};
      }
      motions = panel::move_controls(motions, sweeps, h).motions;
      for (const panel::ControlMotion& m : motions) {
        ASSERT_GE(m.position, 0);
        ASSERT_LE(m.position, 1);
        ASSERT_LE(std::abs(m.velocity), panel::max_control_speed);
      }
    }
    const panel::ControlMotions still = rest(motions, std::max(200, static_cast<int>(0.5 / h)));
    for (std::size_t k = 0; k < 5; ++k) EXPECT_EQ(still[k].position, 0) << h;
  }
}

TEST(PanelMotion, IsAFunctionOfItsArguments) {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> place(-0.12, 0.12);
  for (int i = 0; i < 50; ++i) {
    std::vector<panel::FingerSweep> sweeps(6);
    for (panel::FingerSweep& s : sweeps) {
      s.from = finger_at({place(random), place(random), 0.01});
      s.to = finger_at(s.from.a + Vec3(0.01, 0, -0.015));
    }
    const panel::MovedControls a = panel::move_controls(at_rest(), sweeps, tick),
                               b = panel::move_controls(at_rest(), sweeps, tick);
    for (std::size_t k = 0; k < panel_control_count; ++k) {
      EXPECT_EQ(a.motions[k].position, b.motions[k].position);
      EXPECT_EQ(a.motions[k].velocity, b.motions[k].velocity);
    }
  }
}

}  // namespace
}  // namespace prosector::test
