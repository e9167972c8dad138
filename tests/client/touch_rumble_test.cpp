// What a gamepad's motors do as its user's hand touches.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "client/app/desk/touch_rumble.h"

namespace prosector {
namespace {

constexpr double frame = 1. / 60;  // s

struct MotorLog {
  std::vector<std::pair<double, double>> levels;
  bool there = true;
  int opened = 0;
};

class LoggedMotors final : public RumbleMotors {
 public:
  explicit LoggedMotors(MotorLog& log) : log_(log) {}
  bool set(double strong, double weak) override {
    log_.levels.emplace_back(strong, weak);
    return log_.there;
  }

 private:
  MotorLog& log_;
};

TEST(Rumble, BurstsAtATouchAndThenFollowsItsForce) {
  MotorLog log;
  Rumble rumble(std::make_unique<LoggedMotors>(log));
  for (int k = 0; k < 60; ++k) rumble.follow(0, frame);
  EXPECT_TRUE(log.levels.empty()) << "nothing touches: nothing is told";
  rumble.follow(2, frame);
  ASSERT_EQ(log.levels.size(), 1u);
  EXPECT_GT(log.levels[0].second, 0.5);
  for (int k = 0; k < 120; ++k) rumble.follow(2, frame);
  EXPECT_NEAR(log.levels.back().first, 0.25, 0.02) << "a quarter of what it can";
  EXPECT_EQ(log.levels.back().second, 0) << "nothing changes any more";
  const std::size_t before = log.levels.size();
  for (int k = 0; k < 60; ++k) rumble.follow(2, frame);
  EXPECT_GE(log.levels.size(), before + 2) << "motors stop by themselves if nothing comes";
  for (int k = 0; k < 60; ++k) rumble.follow(0, frame);
  EXPECT_EQ(log.levels.back(), std::pair(0., 0.));
}

TEST(Rumble, KeepsItsRangeWhateverComes) {
  MotorLog log;
  Rumble rumble(std::make_unique<LoggedMotors>(log));
  for (const double force : {1e9, -5., std::nan(""), 1e308, 0.})
    for (int k = 0; k < 10; ++k) rumble.follow(force, k == 3 ? -1 : frame);
  for (const auto& [strong, weak] : log.levels) {
    EXPECT_TRUE(strong >= 0 && strong <= 1) << strong;
    EXPECT_TRUE(weak >= 0 && weak <= 1) << weak;
  }
}

TEST(TouchRumble, OpensAGamepadOnlyWhereThereIsOneAndAgainAfterItWasGone) {
  MotorLog log;
  TouchRumble rumble([&] {
    ++log.opened;
    return std::make_unique<LoggedMotors>(log);
  });
  std::int64_t now = 0;
  const auto frames = [&](int count, bool has, double force) {
    for (int k = 0; k < count; ++k) rumble.follow(has, force, now += 16'666'667);
  };
  frames(60, false, 3);
  EXPECT_EQ(log.opened, 0);
  frames(60, true, 3);
  EXPECT_EQ(log.opened, 1);
  EXPECT_FALSE(log.levels.empty());
  log.there = false;
  frames(30, true, 0);
  log.there = true;
  const std::size_t before = log.levels.size();
  frames(600, true, 5);
  EXPECT_EQ(log.opened, 2);
  EXPECT_GT(log.levels.size(), before);
}

}  // namespace
}  // namespace prosector
