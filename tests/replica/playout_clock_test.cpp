#include "client/replica/playout_clock.h"

#include <gtest/gtest.h>

#include <random>

namespace prosector {
namespace {

constexpr double rate = 60;
constexpr std::int64_t second = 1'000'000'000;

std::int64_t made_at(std::uint64_t tick) {
  return static_cast<std::int64_t>(1e9 * static_cast<double>(tick) / rate);
}

TEST(PlayoutClock, RunsSteadilyBehindJitterAndNeverAhead) {
  PlayoutClock clock(rate);
  std::mt19937 random(1);
  std::uniform_int_distribution<std::int64_t> jitter(0, 10'000'000);
  double last = 0;
  for (std::uint64_t tick = 1; tick < 600; ++tick) {
    const std::int64_t arrival = 5 * second + made_at(tick) + 20'000'000 + jitter(random);
    clock.arrived({0, tick}, arrival);
    const double head = clock.playhead(5 * second + made_at(tick) + 35'000'000);
    EXPECT_GE(head, last);
    if (tick > 120) {
      EXPECT_LT(head, static_cast<double>(tick));
      EXPECT_NEAR(head - last, 1, 0.2);  // one tick a tick: no stutter
    }
    last = head;
  }
  EXPECT_LT(clock.delay_ms(), 10 + 1.01e3 / rate);
}

TEST(PlayoutClock, FollowsASlowedSimulation) {
  PlayoutClock clock(rate);
  double head = 0;
  for (std::uint64_t tick = 1; tick < 600; ++tick) {
    const std::int64_t arrival = second + 2 * made_at(tick);  // half speed
    clock.arrived({0, tick}, arrival);
    head = clock.playhead(arrival);
    if (tick > 60) {  // the first second teaches the slope
      EXPECT_LE(head, static_cast<double>(tick));
    }
  }
  EXPECT_GT(head, 560);
}

TEST(PlayoutClock, FollowsARecordingThatRunsFaster) {
  for (const double pace : {2.0, 4.0, 8.0}) {
    PlayoutClock clock(rate);
    clock.set_pace(pace);
    double head = 0;
    for (std::uint64_t picture = 1; picture < 300; ++picture) {
      const auto tick = static_cast<std::uint64_t>(pace * static_cast<double>(picture));
      clock.arrived({0, tick}, second + made_at(picture));
      const double before = head;
      head = clock.playhead(second + made_at(picture));
      if (picture < 90) continue;
      EXPECT_LE(head, static_cast<double>(tick));
      EXPECT_NEAR(head - before, pace, 0.3 * pace) << "no stutter";
    }
    EXPECT_GT(head, 299 * pace - 20 * pace);
  }
}

TEST(PlayoutClock, StandsStillAtOnceInANewEpochWhileTimeStands) {
  PlayoutClock clock(rate);
  clock.set_pace(0);
  clock.arrived({1, 600}, second);
  for (int picture = 0; picture < 20; ++picture)
    EXPECT_LE(clock.playhead(second + made_at(static_cast<std::uint64_t>(picture))), 600);
}

TEST(PlayoutClock, ANewEpochStartsAnew) {
  PlayoutClock clock(rate);
  for (std::uint64_t tick = 1000; tick < 1100; ++tick) clock.arrived({0, tick}, made_at(tick));
  EXPECT_GT(clock.playhead(made_at(1100)), 1090);
  clock.arrived({1, 10}, made_at(1101));
  clock.arrived({0, 1102}, made_at(1102));  // a straggler of the old epoch
  EXPECT_LT(clock.playhead(made_at(1102)), 20);
}

}  // namespace
}  // namespace prosector
