// What a desk user does with panels.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "common/panel_placement.h"
#include "tests/client/at_the_desk.h"

namespace prosector {
namespace {

using test::AtTheDesk;

bool is_closing(const CommandBody& command) {
  return std::holds_alternative<ClosePanel>(command);
}

TEST_F(AtTheDesk, APanelThatWasAskedForComesIntoThePicture) {
  update();
  Panel panel;
  panel.pose = {{0.3, 1.6, 0}, Quat::Identity()};
  session.own_panel = panel;
  const Pose before = desk.view().eye();
  wait(300);
  EXPECT_EQ(desk.view().eye().p, before.p) << "nobody asked";
  session.own_panel.reset();
  press(key_of('P'));
  EXPECT_TRUE(desk.panel_opening().take_request());
  desk.panel_opening().expect();
  session.own_panel = panel;
  wait(300);
  const DrawCamera camera = mono_camera(desk.view().eye(), DeskStart().fov, 800, 600);
  for (const double side : {-1.0, 1.0}) {
    const Vec3 corner =
        camera.pose.inverse() * (panel.pose * Vec3(side * panel_width / 2, side * panel_height / 2, 0));
    EXPECT_LT(std::abs(corner.x() / corner.z()), camera.right);
    EXPECT_LT(std::abs(corner.y() / corner.z()), camera.top);
  }
  EXPECT_GT((desk.view().eye().p - target).dot(before.p - target), 0) << "from the same side";
}

/// A hand that hovers may graze an organ, such as while the view turns. Its panel would hide what is looked
/// at.
TEST_F(AtTheDesk, APanelThatAHoveringHandOpensIsClosedAndNoOther) {
  const auto closes_new_panel = [&](std::optional<BodyId> touched, bool asked) {
    session.own_panel.reset();
    session.touched = touched;
    update();
    if (asked) desk.panel_opening().expect();
    desk.take_commands();
    session.own_panel = Panel();
    session.own_panel->body = 3;
    update();
    const std::vector<CommandBody> commands = desk.take_commands();
    return std::ranges::count_if(commands, is_closing) == 1;
  };
  EXPECT_TRUE(closes_new_panel(3, false));
  EXPECT_FALSE(closes_new_panel(3, true)) << "asked for";
  EXPECT_FALSE(closes_new_panel(2, false)) << "it touches another body";
  EXPECT_FALSE(closes_new_panel(std::nullopt, false)) << "the terminal asked for it";
  window.events.push_back(MouseButtonEvent{MouseButton::left, true});
  EXPECT_FALSE(closes_new_panel(3, false)) << "the button brought it in";
}

TEST_F(AtTheDesk, APanelIsClosedWhereTheUserGoesToAnotherView) {
  const auto closes = [&] {
    const std::vector<CommandBody> commands = desk.take_commands();
    return std::ranges::count_if(commands, is_closing) == 1;
  };
  for (const Key key : {Key::home, key_of('4')}) {
    press(key);
    EXPECT_FALSE(closes()) << "there is none";
  }
  session.own_panel = Panel();
  update();
  EXPECT_FALSE(closes());
  for (const Key key : {key_of('4'), Key::home}) {
    press(key);
    EXPECT_FALSE(closes()) << "not before the view is there: a hand that touches would bring it up as it was";
    wait(400);
    EXPECT_TRUE(closes());
  }
  press(key_of('9'));
  wait(20);
  EXPECT_FALSE(closes()) << "no view is saved there";
  window.events.push_back(KeyEvent{Key::control, true, false});
  press(key_of('4'));
  wait(400);
  EXPECT_FALSE(closes()) << "the view is saved, not changed";
}

TEST_F(AtTheDesk, APanelIsDraggedByItsHeadScrolledAndPutBack) {
  Panel panel;
  panel.body = 3;
  panel.pose = {{0, 1.15, 0.3}, Quat::Identity()};  // in the picture: the pointer can't leave it
  session.own_panel = panel;
  session.hidden_panel_lines = 2;
  update();
  const auto pixel_of = [&](const Vec3& on_board) -> MouseMoved {
    const DrawCamera camera = mono_camera(desk.view().eye(), DeskStart().fov, 800, 600);
    const Vec3 seen = camera.pose.inverse() * (panel.pose * on_board);
    const Eigen::Vector2d tangents = seen.head<2>() / -seen.z();
    return {800 * (tangents.x() - camera.left) / (camera.right - camera.left),
            600 * (camera.top - tangents.y()) / (camera.top - camera.bottom)};
  };
  const MouseMoved head = pixel_of({0, panel_info.top - 0.005, 0});
  const auto drag = [&](double pixels) {
    window.events.insert(window.events.end(),
                         {head, MouseButtonEvent{MouseButton::left, true},
                          MouseMoved{head.x + pixels, head.y}, MouseButtonEvent{MouseButton::left, false}});
    update();
  };
  window.events = {head, WheelTurned{0, -1}};
  drag(60);
  ASSERT_TRUE(desk.panel().look().place);
  EXPECT_GT(desk.panel().look().place->p.x(), 0.02) << "to the right, as the pointer";
  EXPECT_NEAR(desk.panel().look().place->p.y(), 1.15, 1e-12) << "level, as the pointer";
  EXPECT_NEAR(desk.panel().look().place->p.z(), 0.3, 1e-12) << "as far along the view as it was";
  EXPECT_EQ(desk.panel().look().first_line, 1u);
  window.events = {WheelTurned{0, -9}};
  update();
  EXPECT_EQ(desk.panel().look().first_line, 2u) << "and no farther than to the last line";
  const auto placings = [&] {
    std::vector<OpenPanel> out;
    for (const CommandBody& command : desk.take_commands()) {
      const auto& open = std::get<OpenPanel>(command);  // pointed at, it stays
      EXPECT_EQ(open.body, 3u);
      if (open.placing != PanelPlacement::stays) out.push_back(open);
    }
    return out;
  };
  const std::vector<OpenPanel> put = placings();
  ASSERT_EQ(put.size(), 1u) << "everyone is to see it there";
  EXPECT_EQ(put[0].placing, PanelPlacement::put);
  EXPECT_EQ(put[0].at, desk.panel().look().place->p);
  session.own_panel->pose.p = put[0].at + Vec3(1e-7, 0, 0);
  update();
  EXPECT_FALSE(desk.panel().look().place) << "the server has it there";
  panel.pose = session.own_panel->pose;
  for (int k = 0; k < 2; ++k) {
    window.events.push_back(MouseButtonEvent{MouseButton::left, true});
    window.events.push_back(MouseButtonEvent{MouseButton::left, false});
  }
  window.events.insert(window.events.begin(), pixel_of({0, panel_info.top - 0.005, 0}));
  wait(60);
  EXPECT_FALSE(desk.panel().look().place);
  const std::vector<OpenPanel> back = placings();
  ASSERT_EQ(back.size(), 1u) << "a double click puts it back, for everyone";
  EXPECT_EQ(back[0].placing, PanelPlacement::put_back);
  session.own_panel->pose.p = {0, 1.15, 0.3};
  update();
  drag(-60);
  ASSERT_TRUE(desk.panel().look().place);
  session.own_panel->pose.p.x() += 0.1;
  update();
  EXPECT_TRUE(desk.panel().look().place) << "on its way there";
  wait(1200);
  EXPECT_FALSE(desk.panel().look().place) << "a fist carries it: it stands where everyone has it";
  EXPECT_EQ(desk.panel().look().first_line, 2u);
  session.own_panel->body = 4;
  update();
  EXPECT_EQ(desk.panel().look().first_line, 0u) << "another panel starts at its first line";
}

}  // namespace
}  // namespace prosector
