// What keys and mouse of a desk user ask for, and the figures that they are shown.

#include "client/app/desk/desk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <thread>

#include "client/app/desk/figures.h"
#include "client/view/camera.h"
#include "common/panel_placement.h"
#include "tests/client/acted_window.h"

namespace prosector {
namespace {

using test::ActedWindow;

class AtTheDesk : public testing::Test {
 protected:
  ActedWindow window;
  Desk desk{window, {}};
  const Vec3 target{0, 1, 0};
  DeskSession session;

  void SetUp() override {
    DeskStart start;
    start.home = place_of({0, 1.5, 1}, target);
    start.views[3] = ViewPlace{target, 0, max_view_pitch, 2};
    desk.begin(start);
    session.is_soft = [](BodyId) { return true; };
    // A floor at the target's height.
    session.room.surface = [this](const Ray& ray) -> std::optional<Picked> {
      const double distance = (target.y() - ray.from.y()) / ray.along.y();
      if (!(distance > 0)) return std::nullopt;
      return Picked{{distance, ray.from + distance * ray.along, Vec3::UnitY()}, 0};
    };
    session.room.box = [](BodyId) { return Eigen::AlignedBox3d(Vec3(-1, 0.9, -1), Vec3(1, 1, 1)); };
  }
  void update() { desk.update(session); }
  void wait(int milliseconds) {
    for (int k = 0; k < milliseconds; k += 10) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      session.physical_hand = desk.input().hands[right_hand].pose;
      update();
    }
  }
  void hold(Key key, const std::vector<WindowEvent>& meanwhile) {
    window.events.push_back(KeyEvent{key, true, false});
    window.events.insert(window.events.end(), meanwhile.begin(), meanwhile.end());
    window.events.push_back(KeyEvent{key, false, false});
    update();
  }
  std::vector<WindowEvent> drag(double x, double y) {
    window.drag_right(x, y);
    return std::exchange(window.events, {});
  }
  double distance() const { return (desk.view().eye().p - target).norm(); }
  void press(Key key) {
    window.press(key);
    update();
  }
};

bool is_closing(const CommandBody& command) {
  return std::holds_alternative<ClosePanel>(command);
}

TEST_F(AtTheDesk, AKeyPressedTurnsOnAndOffOnceHoweverLongItIsHeld) {
  press(Key::f1);
  EXPECT_TRUE(desk.display().choices().help);
  press(key_of('H'));
  EXPECT_FALSE(desk.display().choices().help);
  press(key_of('I'));
  EXPECT_TRUE(desk.display().choices().figures);
  press(Key::f11);
  EXPECT_TRUE(desk.display().choices().full_screen);
  press(Key::tab);
  press(Key::tab);
  EXPECT_EQ(desk.display().take_follow_requests(), 2u);
  EXPECT_EQ(desk.display().take_follow_requests(), 0u);
  EXPECT_FALSE(desk.closed());
  press(Key::escape);
  EXPECT_TRUE(desk.closed());
}

TEST_F(AtTheDesk, KeysAskForTimeToStopGoOnSlowDownAndStep) {
  const auto asked = [&](Key key, double pace) {
    session.pace = pace;
    update();
    desk.take_commands();
    press(key);
    const std::vector<CommandBody> commands = desk.take_commands();
    EXPECT_EQ(commands.size(), 1u);
    return commands.empty() ? CommandBody() : commands.front();
  };
  const auto pace = [&](Key key, double now) { return std::get<SetPace>(asked(key, now)).pace; };
  EXPECT_EQ(pace(Key::space, 1), 0);
  EXPECT_EQ(pace(Key::space, 0.25), 0);
  EXPECT_EQ(pace(Key::space, 0), 1);
  EXPECT_EQ(pace(key_of(','), 1), 0.5);
  EXPECT_EQ(pace(key_of(','), min_pace), min_pace);
  EXPECT_EQ(std::get<StepTicks>(asked(key_of('.'), 0)).ticks, 1u);
}

TEST_F(AtTheDesk, KnowsWhatThePointerIsAt) {
  update();
  EXPECT_EQ(desk.pointed(), std::optional<BodyId>(0));
  session.room.surface = [](const Ray&) -> std::optional<Picked> { return std::nullopt; };
  update();
  EXPECT_EQ(desk.pointed(), std::nullopt);
}

TEST_F(AtTheDesk, ThePointerPointsThroughTheWindow) {
  // Tells whether the room is asked what lies along the ray, among others.
  const auto asks_along = [&](double x, double y, const Ray& ray) {
    bool asked = false;
    session.room.surface = [&](const Ray& other) -> std::optional<Picked> {
      asked |= (other.from - ray.from).norm() < 1e-9 && (other.along - ray.along).norm() < 1e-9;
      return std::nullopt;
    };
    window.events = {MouseMoved{x, y}};
    update();
    return asked;
  };
  const DrawCamera rest = desk.view().camera();
  EXPECT_TRUE(asks_along(100, 500, ray_through(rest, 100, 500)));
  desk.view().set_window_look(WindowLook{{0.2, 0.1, 0.5}, 0.3, false});
  const DrawCamera seen = desk.view().camera();
  EXPECT_GT((seen.pose.p - rest.pose.p).norm(), 0.1);
  const Ray middle = ray_through(seen, 400, 300);
  EXPECT_LT((target - middle.from).normalized().cross(middle.along).norm(), 1e-9)
      << "the target lies in the screen";
  EXPECT_TRUE(asks_along(100, 500, ray_through(seen, 100, 500)));
  EXPECT_FALSE(asks_along(100, 500, ray_through(rest, 100, 500)));
  EXPECT_EQ(desk.view().eye().p, rest.pose.p) << "the place that is turned and saved stays the desk's own";
}

TEST_F(AtTheDesk, VGoesThroughAllThatColoursTell) {
  for (const Shown expected : {Shown::strain, Shown::residual, Shown::error, Shown::none}) {
    press(key_of('V'));
    EXPECT_EQ(desk.display().choices().shown, expected);
  }
}

TEST_F(AtTheDesk, XOpensBodiesAtAPlaneThatTheWheelMovesWhileItIsHeld) {
  const Key x = key_of('X');
  press(x);
  ASSERT_TRUE(desk.display().choices().section);
  const SectionPlane first = *desk.display().choices().section;
  EXPECT_GT(first.height(desk.view().eye().p), 0) << "the eye's side is taken away";
  EXPECT_NEAR(first.height({0, 0.95, 0}), 0, 1e-9) << "the middle of what the pointer is at";
  hold(x, {WheelTurned{0, 2}});
  ASSERT_TRUE(desk.display().choices().section) << "moving does not close";
  EXPECT_EQ(desk.display().choices().section->normal, first.normal);
  EXPECT_LT(desk.display().choices().section->offset, first.offset) << "away from the eye";
  press(x);
  EXPECT_FALSE(desk.display().choices().section);
}

TEST_F(AtTheDesk, TheViewTurnsAboutItsTargetOrWithFAboutTheEye) {
  update();
  const Vec3 eye = desk.view().eye().p;
  const double distance = (eye - target).norm();
  window.drag_right(80, 40);
  update();
  EXPECT_GT((desk.view().eye().p - eye).norm(), 0.2);
  const Vec3 ahead = desk.view().eye().q * -Vec3::UnitZ();
  EXPECT_LT((desk.view().eye().p + distance * ahead - target).norm(), 1e-9) << "still in the middle";
  const Pose before = desk.view().eye();
  press(key_of('F'));
  window.drag_right(-80, 20);
  update();
  EXPECT_LT((desk.view().eye().p - before.p).norm(), 1e-9);
  EXPECT_GT(desk.view().eye().q.angularDistance(before.q), 0.3);
}

// At a few pictures a second a tap begins and ends between two of them.
TEST_F(AtTheDesk, AKeyTappedBetweenTwoPicturesMovesTheViewAsLongAsOne) {
  update();
  for (const char key : {'W', 'A', 'S', 'D', 'Q', 'E'}) {
    update();
    const Vec3 before = desk.view().eye().p;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    window.events = {KeyEvent{key_of(key), true, false}, KeyEvent{key_of(key), false, false}};
    update();
    const Vec3 after = desk.view().eye().p;
    EXPECT_GT((after - before).norm(), 1e-3) << key;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    update();
    EXPECT_EQ(desk.view().eye().p, after) << key << " is no longer held";
  }
}

TEST_F(AtTheDesk, ZoomsByKeysDragAndPinch) {
  update();
  const double first = distance();
  hold(Key::control, {WheelTurned{0, 3}});
  EXPECT_NEAR(distance(), first * std::exp(-0.3), 1e-9) << "a pinch comes as Ctrl and wheel";
  hold(Key::control, drag(0, 60));
  EXPECT_NEAR(distance(), first, 1e-9);
  window.events = {KeyEvent{key_of('-'), true, false}};
  wait(50);
  EXPECT_GT(distance(), 1.02 * first);
  window.events = {KeyEvent{key_of('-'), false, false}, KeyEvent{key_of('='), true, false}};
  wait(150);
  EXPECT_LT(distance(), first);
  EXPECT_LT((desk.view().eye().q.angularDistance(place_of({0, 1.5, 1}, target).pose().q)), 1e-9);
}

TEST_F(AtTheDesk, WhatWasUnderThePointerStaysThereWhenTheViewIsMoved) {
  update();
  const auto ray_at = [&](double x, double y) {
    return ray_through(mono_camera(desk.view().eye(), DeskStart().fov, 800, 600), x, y);
  };
  const auto point = session.room.surface(ray_at(100, 100));
  ASSERT_TRUE(point);
  hold(Key::shift, drag(170, -40));
  const Ray ray = ray_at(270, 60);
  EXPECT_LT((point->at - ray.from).normalized().cross(ray.along).norm(), 1e-9);
}

TEST_F(AtTheDesk, HomeAndNumbersBringTheViewToSavedPlaces) {
  update();
  const Pose home = desk.view().eye();
  window.drag_right(200, 60);
  update();
  const Pose turned = desk.view().eye();
  hold(Key::control, {KeyEvent{key_of('7'), true, false}, KeyEvent{key_of('7'), false, false}});
  press(key_of('8'));
  wait(300);
  EXPECT_LT((desk.view().eye().p - turned.p).norm(), 1e-9) << "nothing was saved there";
  press(Key::home);
  wait(40);
  EXPECT_GT((desk.view().eye().p - home.p).norm(), 1e-3) << "smoothly";
  wait(300);
  EXPECT_LT((desk.view().eye().p - home.p).norm(), 1e-9);
  press(key_of('4'));
  wait(300);
  EXPECT_GT(desk.view().eye().p.y(), 2.9) << "from above";
  press(key_of('7'));
  wait(300);
  EXPECT_LT((desk.view().eye().p - turned.p).norm(), 1e-9);
}

TEST_F(AtTheDesk, ADoubleClickFramesWhatIsThereAndGraspsNothing) {
  update();
  const auto click = [&] {
    window.events.insert(window.events.end(),
                         {MouseMoved{300, 320}, MouseButtonEvent{MouseButton::left, true}});
    wait(30);
    window.events.push_back(MouseButtonEvent{MouseButton::left, false});
    wait(30);
  };
  const Ray at = ray_through(mono_camera(desk.view().eye(), DeskStart().fov, 800, 600), 300, 320);
  const Vec3 clicked = session.room.surface(at)->at;
  click();
  click();
  wait(300);
  EXPECT_TRUE(desk.take_commands().empty());
  const Vec3 ahead = desk.view().eye().q * -Vec3::UnitZ();
  EXPECT_LT((clicked - desk.view().eye().p).cross(ahead).norm(), 1e-9) << "in the middle now";
  EXPECT_NEAR((clicked - desk.view().eye().p).norm(), 0.5, 1e-9) << "brought near: it is too large to frame";
  session.room.box = [&](BodyId) {
    return Eigen::AlignedBox3d(clicked - Vec3::Constant(0.1), clicked + Vec3::Constant(0.1));
  };
  press(key_of('G'));
  wait(300);
  EXPECT_GT((clicked - desk.view().eye().p).norm(), 0.5) << "framed";
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
  EXPECT_EQ(desk.panel().look().first_line, 0u) << "another one begins anew";
}

TEST_F(AtTheDesk, ThePointerBringsTheHandOverTheSurface) {
  for (const auto& [x, y] : {std::pair(400.0, 300.0), std::pair(200.0, 400.0), std::pair(650.0, 500.0)}) {
    window.events.push_back(MouseMoved{x, y});
    wait(800);
    const Ray ray = ray_through(mono_camera(desk.view().eye(), DeskStart().fov, 800, 600), x, y);
    const Pose hand = desk.input().hands[right_hand].pose;
    const Vec3 fingertips = hand * Vec3(0, 0, -wrist_to_fingertips);
    const double distance = (fingertips - ray.from).dot(ray.along);
    EXPECT_LT((fingertips - ray.from - distance * ray.along).norm(), 1e-6) << x;
    EXPECT_LE(distance, session.room.surface(ray)->distance - first_hover + 1e-9) << x;
    EXPECT_GT(distance, session.room.surface(ray)->distance - 0.2) << x;
  }
}

TEST_F(AtTheDesk, TheWheelTurnsTheWristAboutTheFingertipsWithShiftAndAlt) {
  session.room.surface = [](const Ray&) { return std::optional<Picked>(); };  // nothing to stay clear of
  wait(500);
  const auto wheel = [&](Key held, double x, double y) {
    hold(held, {WheelTurned{x, y}});
    return desk.input().hands[right_hand].pose;
  };
  const auto fingers = [](const Pose& pose) { return Vec3(pose.q * -Vec3::UnitZ()); };
  const auto fingertips = [&](const Pose& pose) { return Vec3(pose.p + 0.18 * fingers(pose)); };
  const Pose first = wheel(Key::shift, 0, 0);
  const Pose rolled = wheel(Key::shift, 0, 5);
  EXPECT_NEAR(rolled.q.angularDistance(first.q), 0.5, 1e-9);
  const Vec3 heading = Vec3(fingers(first).x(), 0, fingers(first).z()).normalized();
  EXPECT_LT((rolled.q * first.q.conjugate() * heading - heading).norm(), 1e-9)
      << "what pointed where the hand heads still does";
  EXPECT_LT((rolled.q * Vec3::UnitX()).y(), (first.q * Vec3::UnitX()).y()) << "clockwise";
  EXPECT_NEAR(wheel(Key::shift, 5, 0).q.angularDistance(first.q), 1, 1e-9) << "a wheel turned sideways";
  wheel(Key::shift, 0, -10);
  const Pose bent = wheel(Key::alt, 0, 3);
  EXPECT_NEAR(bent.q.angularDistance(first.q), 0.3, 1e-9);
  EXPECT_GT(fingers(bent).y(), fingers(first).y());
  wheel(Key::alt, 0, 1000);
  EXPECT_LT((fingertips(wheel(Key::alt, 0, -7)) - fingertips(first)).norm(), 1e-9);
  wheel(Key::space, 0, -5);
  wait(300);
  EXPECT_NEAR((fingertips(desk.input().hands[right_hand].pose) - fingertips(first)).norm(), 0.05, 1e-6)
      << "without them it is how far";
}

TEST_F(AtTheDesk, AGamepadDoesWhatKeysAndMouseDo) {
  update();
  const Pose before = desk.view().eye();
  Gamepad pad;
  pad.left = {0.1, -0.08};  // worn, at rest
  const auto show = [&] {
    window.events.push_back(GamepadMoved{pad});
    update();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    update();
  };
  show();
  EXPECT_EQ(desk.view().eye().p, before.p);
  pad.left = {1, 0};
  show();
  EXPECT_GT((desk.view().eye().p - before.p).x(), 0.005) << "to the right";
  pad = {};
  pad.right = {0, 1};
  const Pose turned = desk.view().eye();
  show();
  EXPECT_GT(desk.view().eye().q.angularDistance(turned.q), 0.01);

  const Pose hand = desk.input().hands[right_hand].pose, eye = desk.view().eye();
  pad.right = {1, 0};
  pad.left_trigger = 1;  // the pointer instead
  show();
  EXPECT_EQ(desk.view().eye().p, eye.p);
  EXPECT_GT((desk.input().hands[right_hand].pose.p - hand.p).norm(), 0.005);

  const Quat wrist = desk.input().hands[right_hand].pose.q;
  pad.right = {0, 0};
  pad.down[static_cast<std::size_t>(PadButton::right_bumper)] = true;  // rolls the hand, and lifts no view
  show();
  EXPECT_GT(desk.input().hands[right_hand].pose.q.angularDistance(wrist), 0.01);
  EXPECT_EQ(desk.view().eye().p, eye.p);

  pad = {};
  pad.left_trigger = 1;
  pad.left = {0, 1};  // zooms, and turns nothing
  show();
  EXPECT_LT(desk.view().eye().q.angularDistance(eye.q), 1e-9);
  EXPECT_GT((desk.view().eye().p - eye.p).dot(eye.q * Vec3::UnitZ()), 0.005);
  pad = {};
  pad.left_trigger = 1;
  pad.down[static_cast<std::size_t>(PadButton::start)] = true;
  show();
  EXPECT_TRUE(desk.parts().is_open());
  EXPECT_FALSE(desk.display().choices().help) << "the same button without the trigger";
  pad = {};
  show();
  pad.down[static_cast<std::size_t>(PadButton::north)] = true;
  show();
  EXPECT_EQ(desk.display().take_follow_requests(), 1u) << "no key types into the search";
  pad = {};
  pad.left_trigger = 1;
  pad.down[static_cast<std::size_t>(PadButton::start)] = true;
  show();
  EXPECT_FALSE(desk.parts().is_open());
  pad = {};
  show();
  pad.right_trigger = 1;
  show();
  wait(700);
  pad.down[static_cast<std::size_t>(PadButton::start)] = true;
  show();
  EXPECT_TRUE(desk.display().choices().help);
  window.events.push_back(GamepadMoved{std::nullopt});  // unplugged while it grasps
  update();
  const std::vector<CommandBody> commands = desk.take_commands();
  ASSERT_EQ(commands.size(), 2u);
  EXPECT_TRUE(std::holds_alternative<Grasp>(commands[0]));
  EXPECT_TRUE(std::holds_alternative<Release>(commands[1]));
}

TEST(Figures, AreOfTheLastHalfSecond) {
  Figures figures;
  BusCounters counters;
  ServerStatus status;
  status.step_ms_p50 = 4.2;
  status.real_time_factor = 1;
  constexpr std::int64_t picture = 50'000'000;  // ns
  for (int k = 0; k <= 10; ++k) {
    EXPECT_EQ(figures.text(), "");
    counters.bytes_in += 5000;
    counters.bytes_out += 500;
    counters.dropped_total = 3;
    figures.take(k * picture, k == 4 ? 0.040 : 0.010, counters, &status);
  }
  const std::string& text = figures.text();
  EXPECT_NE(text.find("frame 13.0 ms (mean), 40.0 ms (max), 20 frames per second"), std::string::npos)
      << text;
  EXPECT_NE(text.find("network 100.0 kB/s in, 10.0 kB/s out, 3 samples dropped"), std::string::npos) << text;
  EXPECT_NE(text.find("step 4.2 ms"), std::string::npos) << text;
}

}  // namespace
}  // namespace prosector
