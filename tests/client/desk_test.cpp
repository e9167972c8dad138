// What keys and mouse of a desk user ask for, and the figures that they are shown.

#include "client/app/desk.h"

#include <gtest/gtest.h>

#include <thread>

#include "client/app/figures.h"

namespace prosector {
namespace {

/// A window in which somebody acts.
class ActedWindow final : public WindowContext {
 public:
  std::vector<WindowEvent> events;

  void press(Key key) {
    events.push_back(KeyEvent{key, true, false});
    events.push_back(KeyEvent{key, true, true});  // held
    events.push_back(KeyEvent{key, false, false});
  }
  void drag_right(double x, double y) {
    events.insert(events.end(), {MouseMoved{100, 100}, MouseButtonEvent{MouseButton::right, true},
                                 MouseMoved{100 + x, 100 + y}, MouseButtonEvent{MouseButton::right, false}});
  }

  std::vector<WindowEvent> poll_events() override { return std::exchange(events, {}); }
  void capture_pointer(bool) override {}
  void set_full_screen(std::optional<int>) override {}
  void open_audience(const Audience&) override {}
  double content_scale() const override { return 1; }
  void* proc(const char*) const override { return nullptr; }
  int width() const override { return 800; }
  int height() const override { return 600; }
  bool has_screen() const override { return true; }
  void present() override {}
  std::string description() const override { return "a window in which somebody acts"; }
};

class AtTheDesk : public testing::Test {
 protected:
  ActedWindow window;
  Desk desk{window, Shown::none, false};
  const CameraInfo start{{0, 1.5, 1}, {0, 1, 0}, 0.9};

  void update() { desk.update(start, nullptr); }
  void press(Key key) {
    window.press(key);
    update();
  }
};

TEST_F(AtTheDesk, AKeyPressedTurnsOnAndOffOnceHoweverLongItIsHeld) {
  press(Key::f1);
  EXPECT_TRUE(desk.help());
  press(key_of('H'));
  EXPECT_FALSE(desk.help());
  press(key_of('I'));
  EXPECT_TRUE(desk.figures());
  press(Key::f11);
  EXPECT_TRUE(desk.full_screen());
  press(Key::tab);
  press(Key::tab);
  EXPECT_EQ(desk.take_follow_requests(), 2u);
  EXPECT_EQ(desk.take_follow_requests(), 0u);
  EXPECT_FALSE(desk.closed());
  press(Key::escape);
  EXPECT_TRUE(desk.closed());
}

TEST_F(AtTheDesk, VGoesThroughAllThatColoursTell) {
  for (const Shown expected : {Shown::strain, Shown::residual, Shown::error, Shown::none}) {
    press(key_of('V'));
    EXPECT_EQ(desk.shown(), expected);
  }
}

TEST_F(AtTheDesk, TheViewTurnsAboutItsTargetOrWithFAboutTheEye) {
  update();
  const Vec3 eye = desk.eye().p;
  const double distance = (eye - start.target).norm();
  window.drag_right(80, 40);
  update();
  EXPECT_GT((desk.eye().p - eye).norm(), 0.2);
  const Vec3 ahead = desk.eye().q * -Vec3::UnitZ();
  EXPECT_LT((desk.eye().p + distance * ahead - start.target).norm(), 1e-9) << "still in the middle";
  const Pose before = desk.eye();
  press(key_of('F'));
  window.drag_right(-80, 20);
  update();
  EXPECT_LT((desk.eye().p - before.p).norm(), 1e-9);
  EXPECT_GT(desk.eye().q.angularDistance(before.q), 0.3);
}

// At a few pictures a second a tap begins and ends between two of them.
TEST_F(AtTheDesk, AKeyTappedBetweenTwoPicturesMovesTheViewAsLongAsOne) {
  update();
  for (const char key : {'W', 'A', 'S', 'D', 'Q', 'E'}) {
    update();
    const Vec3 before = desk.eye().p;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    window.events = {KeyEvent{key_of(key), true, false}, KeyEvent{key_of(key), false, false}};
    update();
    const Vec3 after = desk.eye().p;
    EXPECT_GT((after - before).norm(), 1e-3) << key;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    update();
    EXPECT_EQ(desk.eye().p, after) << key << " is no longer held";
  }
}

TEST_F(AtTheDesk, TheWheelTurnsTheWristAboutTheFingertipsWithShiftAndControl) {
  const auto wheel = [&](Key held, double x, double y) {
    window.events.push_back(KeyEvent{held, true, false});
    window.events.push_back(WheelTurned{x, y});
    window.events.push_back(KeyEvent{held, false, false});
    update();
    return desk.input().hands[right_hand].pose;
  };
  const auto fingers = [](const Pose& pose) { return Vec3(pose.q * -Vec3::UnitZ()); };
  const auto fingertips = [&](const Pose& pose) { return Vec3(pose.p + 0.18 * fingers(pose)); };
  const Pose first = wheel(Key::shift, 0, 0);
  const Pose rolled = wheel(Key::shift, 0, 5);
  EXPECT_NEAR(rolled.q.angularDistance(first.q), 0.5, 1e-9);
  EXPECT_LT((rolled.q * first.q.conjugate() * Vec3::UnitZ() - Vec3::UnitZ()).norm(), 1e-9)
      << "what pointed ahead still does";
  EXPECT_LT((rolled.q * Vec3::UnitX()).y(), (first.q * Vec3::UnitX()).y()) << "clockwise";
  EXPECT_NEAR(wheel(Key::shift, 5, 0).q.angularDistance(first.q), 1, 1e-9) << "a wheel turned sideways";
  wheel(Key::shift, 0, -10);
  const Pose bent = wheel(Key::control, 0, 3);
  EXPECT_NEAR(bent.q.angularDistance(first.q), 0.3, 1e-9);
  EXPECT_GT(fingers(bent).y(), fingers(first).y());
  wheel(Key::control, 0, 1000);
  EXPECT_LT((fingertips(wheel(Key::control, 0, -7)) - fingertips(first)).norm(), 1e-9);
  EXPECT_GT((fingertips(wheel(Key::space, 0, 3)) - fingertips(first)).norm(), 0.05)
      << "without them it is how far";
}

TEST_F(AtTheDesk, AGamepadDoesWhatKeysAndMouseDo) {
  update();
  const Pose before = desk.eye();
  Gamepad pad;
  pad.left = {0.1, -0.08};  // worn, at rest
  const auto hold = [&] {
    window.events.push_back(GamepadMoved{pad});
    update();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    update();
  };
  hold();
  EXPECT_EQ(desk.eye().p, before.p);
  pad.left = {1, 0};
  hold();
  EXPECT_GT((desk.eye().p - before.p).x(), 0.005) << "to the right";
  pad = {};
  pad.right = {0, 1};
  const Pose turned = desk.eye();
  hold();
  EXPECT_GT(desk.eye().q.angularDistance(turned.q), 0.01);

  const Pose hand = desk.input().hands[right_hand].pose, eye = desk.eye();
  pad.right = {1, 0};
  pad.left_trigger = 1;  // the pointer instead
  hold();
  EXPECT_EQ(desk.eye().p, eye.p);
  EXPECT_GT((desk.input().hands[right_hand].pose.p - hand.p).norm(), 0.005);

  const Quat wrist = desk.input().hands[right_hand].pose.q;
  pad.right = {0, 0};
  pad.down[static_cast<std::size_t>(PadButton::right_bumper)] = true;  // rolls the hand, and lifts no view
  hold();
  EXPECT_GT(desk.input().hands[right_hand].pose.q.angularDistance(wrist), 0.01);
  EXPECT_EQ(desk.eye().p, eye.p);

  pad = {};
  pad.right_trigger = 1;
  hold();
  pad.down[static_cast<std::size_t>(PadButton::start)] = true;
  hold();
  EXPECT_TRUE(desk.help());
  window.events.push_back(GamepadMoved{std::nullopt});  // unplugged while it grasps
  update();
  const std::vector<Command> commands = desk.take_commands();
  ASSERT_EQ(commands.size(), 2u);
  EXPECT_EQ(commands[0].kind, CommandKind::grasp);
  EXPECT_EQ(commands[1].kind, CommandKind::release);
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
  EXPECT_NE(text.find("picture 13.0 ms, at most 40.0, 20 a second"), std::string::npos) << text;
  EXPECT_NE(text.find("network 100.0 kB/s in, 10.0 kB/s out, 3 dropped"), std::string::npos) << text;
  EXPECT_NE(text.find("step 4.2 ms"), std::string::npos) << text;
}

}  // namespace
}  // namespace prosector
