// What a gamepad's motors do as its user's hand touches.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "client/app/desk/touch_rumble.h"

namespace prosector {
namespace {

constexpr double frame = 1. / 60;  // s

struct Told {
  std::vector<std::pair<double, double>> levels;
  bool there = true;
  int opened = 0;
};

class ToldMotors final : public RumbleMotors {
 public:
  explicit ToldMotors(Told& told) : told_(told) {}
  bool set(double strong, double weak) override {
    told_.levels.emplace_back(strong, weak);
    return told_.there;
  }

 private:
  Told& told_;
};

TEST(Rumble, BurstsAtATouchAndThenFollowsItsForce) {
  Told told;
  Rumble rumble(std::make_unique<ToldMotors>(told));
  for (int k = 0; k < 60; ++k) rumble.follow(0, frame);
  EXPECT_TRUE(told.levels.empty()) << "nothing touches: nothing is told";
  rumble.follow(2, frame);
  ASSERT_EQ(told.levels.size(), 1u);
  EXPECT_GT(told.levels[0].second, 0.5);
  for (int k = 0; k < 120; ++k) rumble.follow(2, frame);
  EXPECT_NEAR(told.levels.back().first, 0.25, 0.02) << "a quarter of what it can";
  EXPECT_EQ(told.levels.back().second, 0) << "nothing changes any more";
  const std::size_t before = told.levels.size();
  for (int k = 0; k < 60; ++k) rumble.follow(2, frame);
  EXPECT_GE(told.levels.size(), before + 2) << "motors stop by themselves if nothing comes";
  for (int k = 0; k < 60; ++k) rumble.follow(0, frame);
  EXPECT_EQ(told.levels.back(), std::pair(0., 0.));
}

TEST(Rumble, KeepsItsRangeWhateverComes) {
  Told told;
  Rumble rumble(std::make_unique<ToldMotors>(told));
  for (const double force : {1e9, -5., std::nan(""), 1e308, 0.})
    for (int k = 0; k < 10; ++k) rumble.follow(force, k == 3 ? -1 : frame);
  for (const auto& [strong, weak] : told.levels) {
    EXPECT_TRUE(strong >= 0 && strong <= 1) << strong;
    EXPECT_TRUE(weak >= 0 && weak <= 1) << weak;
  }
}

TEST(TouchRumble, OpensAGamepadOnlyWhereThereIsOneAndAgainAfterItWasGone) {
  Told told;
  TouchRumble rumble([&] {
    ++told.opened;
    return std::make_unique<ToldMotors>(told);
  });
  std::int64_t now = 0;
  const auto frames = [&](int count, bool has, double force) {
    for (int k = 0; k < count; ++k) rumble.follow(has, force, now += 16'666'667);
  };
  frames(60, false, 3);
  EXPECT_EQ(told.opened, 0);
  frames(60, true, 3);
  EXPECT_EQ(told.opened, 1);
  EXPECT_FALSE(told.levels.empty());
  told.there = false;
  frames(30, true, 0);
  told.there = true;
  const std::size_t before = told.levels.size();
  frames(600, true, 5);
  EXPECT_EQ(told.opened, 2);
  EXPECT_GT(told.levels.size(), before);
}

}  // namespace
}  // namespace prosector
