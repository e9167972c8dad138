// What keys and mouse of a desk user ask for, and the figures that they are shown.

#include "client/app/desk/desk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <thread>

#include "client/app/desk/figures.h"
#include "client/view/camera.h"
#include "common/panel_placement.h"
#include "tests/client/at_the_desk.h"

namespace prosector {
namespace {

using test::AtTheDesk;

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
