// The time of a recording: where its bar lies, what is read off it, and what keys and pointer ask for.

#include "client/app/desk/time_control.h"

#include <gtest/gtest.h>

#include "client/view/camera.h"

namespace prosector {
namespace {

constexpr std::uint64_t last = 36000;  // ten minutes

OverlayFrame frame_of(int width, int height, double scale = 1) {
  return {mono_camera(Pose{}, 0.8, width, height), scale};
}

TEST(TimeBar, ReadsOffTheTickThatItShows) {
  for (const auto& [width, height] : {std::pair{800, 600}, std::pair{1920, 1080}, std::pair{320, 200}}) {
    const TimeBar bar(frame_of(width, height), last);
    for (std::uint64_t tick = 0; tick <= last; tick += 1200) {
      const double ticks_a_point = static_cast<double>(last) / (bar.right() - bar.left());
      EXPECT_NEAR(static_cast<double>(bar.tick_at(bar.place_of(static_cast<double>(tick)))),
                  static_cast<double>(tick), 1 + 1e-6 * ticks_a_point);
    }
    EXPECT_EQ(bar.tick_at(0), 0u);
    EXPECT_EQ(bar.tick_at(width), last);
    EXPECT_GE(bar.left(), 0);
    EXPECT_LE(bar.right(), std::max(width, 200));
  }
}

TEST(TimeBar, LiesWithinItsStripAtEveryScale) {
  for (const double scale : {1.0, 2.0}) {
    const OverlayFrame frame = frame_of(1600, 1200, scale);
    const TimeBar bar(frame, last);
    const Eigen::Vector2d middle(0.5 * (bar.left() + bar.right()), bar.middle());
    EXPECT_TRUE(bar.is_on(middle));
    EXPECT_FALSE(bar.is_on(middle - Eigen::Vector2d(0, time_bar_strip)));
    EXPECT_GT(bar.middle(), frame.height - time_bar_strip);
    EXPECT_LT(bar.middle(), frame.height);
  }
}

TEST(TimeBar, TellsTimesAndMarksInWords) {
  EXPECT_EQ(clock_time(0, 60), "0:00.0");
  EXPECT_EQ(clock_time(3750, 60), "1:02.5");
  EXPECT_EQ(clock_time(60 * 3723, 60), "1:02:03.0");
  EXPECT_EQ(in_words({60, MarkKind::cut, "Ada"}), "Ada cut");
  EXPECT_EQ(in_words({60, MarkKind::reset, ""}), "someone reset something");
}

TEST(TimeBar, IsDrawnWithItsMarksAndTheTimeAtThePointer) {
  DrawList list;
  list.cameras.push_back(mono_camera(Pose{}, 0.8, 800, 600));
  WatchedTime time;
  time.recording = {last, {{18000, MarkKind::cut, "Ada"}}};
  time.tick = 9000;
  const TimeBar bar(OverlayFrame(list), last);
  time.pointer = {bar.place_of(18000), bar.middle()};
  add_time_bar(list, time);
  ASSERT_EQ(list.texts.size(), 2u);
  EXPECT_EQ(list.texts[0].text, "2:30.0 / 10:00.0");
  EXPECT_EQ(list.texts[1].text, "5:00.0  Ada cut");
  for (const DrawLine& line : list.lines) EXPECT_LT(line.a.y(), -0.9) << "at the lower border";
}

/// Returns the tick of a Seek command. Throws if there is none.
std::uint32_t tick_of(const std::optional<CommandBody>& command) {
  return std::get<Seek>(command.value()).tick;
}

/// Returns the pace of a SetPace command. Throws if there is none.
double pace_of(const std::optional<CommandBody>& command) {
  return std::get<SetPace>(command.value()).pace;
}

class TimeInHand : public testing::Test {
 protected:
  TimeControl control;
  double now = 0;
  ShownTime shown{last, 9000, 60, 1};
  OverlayFrame frame = frame_of(800, 600);
  TimeBar bar{frame, last};

  void see() {
    now += 0.02;
    control.see(shown, now);
  }
  Eigen::Vector2d at(double tick) const { return {bar.place_of(tick), bar.middle()}; }
};

TEST_F(TimeInHand, KeysGoByAndAddUpWhileOnTheWay) {
  see();
  EXPECT_EQ(tick_of(control.press(Key::right)), 9600u);
  see();
  EXPECT_EQ(tick_of(control.press(Key::right)), 10200u) << "from where one wants to be";
  EXPECT_EQ(tick_of(control.press(Key::page_up)), 6600u);
  EXPECT_EQ(tick_of(control.press(Key::backspace)), 0u);
  EXPECT_EQ(tick_of(control.press(Key::left)), 0u) << "not before its beginning";
  shown.tick = 2;
  see();
  EXPECT_FALSE(control.wish()) << "it is there";
  shown.tick = last - 10;
  see();
  EXPECT_EQ(tick_of(control.press(Key::page_down)), last);
}

TEST_F(TimeInHand, KeysMakeItFasterAndSlowerWithinBounds) {
  for (const auto& [pace, faster, slower] :
       {std::tuple{1.0, 2.0, 0.5}, std::tuple{max_pace, max_pace, max_pace / 2},
        std::tuple{min_pace, 2 * min_pace, min_pace}}) {
    shown.pace = pace;
    see();
    EXPECT_EQ(pace_of(control.press(Key::up)), faster);
    EXPECT_EQ(pace_of(control.press(Key::down)), slower);
  }
  shown.pace = 0;
  see();
  EXPECT_EQ(pace_of(control.press(Key::up)), 1);
  EXPECT_FALSE(control.press(Key::down)) << "it stands";
}

TEST_F(TimeInHand, ADragAsksNowAndThenAndAtItsEnd) {
  see();
  ASSERT_TRUE(control.press(frame, at(12000)));
  int asked = 0;
  for (int k = 1; k <= 50; ++k) {
    see();
    asked += control.move(frame, at(12000 + 100 * k)).has_value();
  }
  EXPECT_GE(asked, 4);
  EXPECT_LE(asked, 10) << "a server takes no more";
  const auto end = control.let_go();
  ASSERT_TRUE(end);
  EXPECT_NEAR(tick_of(end), 17000, 1);
  EXPECT_FALSE(control.let_go());
  EXPECT_FALSE(control.move(frame, at(100)));
}

TEST_F(TimeInHand, NothingIsAskedOfALiveSessionOrBesideTheBar) {
  EXPECT_FALSE(control.press(Key::right));
  EXPECT_FALSE(control.press(frame, at(12000)));
  see();
  EXPECT_FALSE(control.press(frame, {400, 300}));
  control.see(std::nullopt, now);
  EXPECT_FALSE(control.watches());
  EXPECT_FALSE(control.press(Key::right));
}

}  // namespace
}  // namespace prosector
