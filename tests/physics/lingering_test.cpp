// Bodies that shiver in their place are calmed and put to rest; what moves on, and what nothing touches, is
// not.

#include "server/physics/mechanics/coupled/vibration.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

namespace prosector::test {
namespace {

constexpr double tick = 1.0 / 60, within = 1e-3;
constexpr BodyId somebody_else = 3;

VecX at(double x) {
  return VecX::Constant(3, x);
}

/// What becomes of a body, tick by tick, of which `place` tells where it is in each.
std::vector<coupled::VibrationState> follow(int ticks, const std::function<double(int)>& place) {
  coupled::Lingerers lingerers(tick);
  std::vector<coupled::VibrationState> out;
  for (int t = 0; t < ticks; ++t) {
    lingerers.begin_tick(static_cast<std::uint64_t>(t));
    out.push_back(lingerers.linger({somebody_else, at(place(t)), within}));
    lingerers.end_tick();
  }
  return out;
}

TEST(Lingerers, CalmWhatShiversInItsPlaceAndThenPutItToRest) {
  const std::vector<coupled::VibrationState> unrest =
      follow(200, [](int t) { return t % 2 ? 0.9 * within : 0; });
  EXPECT_EQ(unrest[119], coupled::VibrationState::moving);
  EXPECT_EQ(unrest[125], coupled::VibrationState::calmed);
  EXPECT_EQ(unrest[145], coupled::VibrationState::calmed);
  EXPECT_EQ(unrest[155], coupled::VibrationState::over);
}

TEST(Lingerers, LetWhatMovesOnMove) {
  for (const coupled::VibrationState unrest : follow(1000, [](int t) { return within * t / 100; }))
    EXPECT_EQ(unrest, coupled::VibrationState::moving);
  for (const coupled::VibrationState unrest :
       follow(1000, [](int t) { return 2 * within * std::sin(0.1 * t); }))
    EXPECT_EQ(unrest, coupled::VibrationState::moving);
}

TEST(Lingerers, BeginAtWholeSecondsAndForgetWhomNobodyAskedAbout) {
  coupled::Lingerers lingerers(tick);
  const auto ask = [&](std::uint64_t t, bool about) {
    lingerers.begin_tick(t);
    if (about) lingerers.linger({somebody_else, at(0), within});
    lingerers.end_tick();
    return lingerers.watched().size();
  };
  EXPECT_EQ(ask(59, true), 0u);
  EXPECT_EQ(ask(60, true), 1u);
  EXPECT_EQ(ask(61, true), 1u);
  EXPECT_EQ(ask(62, false), 0u);
  EXPECT_EQ(ask(63, true), 0u);
}

TEST(Lingerers, BelongToTheHashOnlyOnceTheyChangeTheNextTick) {
  coupled::Lingerers lingerers(tick);
  for (std::uint64_t t = 0; t < 118; ++t) {
    lingerers.begin_tick(t);
    lingerers.linger({somebody_else, at(0), within});
    lingerers.end_tick();
  }
  EXPECT_TRUE(lingerers.calmed_next().empty());
  for (std::uint64_t t = 118; t < 124; ++t) {
    lingerers.begin_tick(t);
    lingerers.linger({somebody_else, at(0), within});
    lingerers.end_tick();
  }
  EXPECT_EQ(lingerers.calmed_next().size(), 1u);
}

}  // namespace
}  // namespace prosector::test
