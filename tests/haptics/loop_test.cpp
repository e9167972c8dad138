// The servo's loop, closed through an arm, a hand, a network and tissue: what users are promised.
#include <gtest/gtest.h>

#include <limits>

#include "tests/haptics/haptic_case.h"

namespace prosector {
namespace {

const HapticScheme ours = {"ours", "", -1, true, {}};
const HapticScheme over_the_net = {"net", "", 0, false, {false, false}};
const HapticScheme stiff_surface = {"stiff", "", 800, false, {false, false}};

constexpr double still = 3e-4;         // m: of ripple
constexpr double passive = -2e-4;      // J
constexpr double just_noticed = 0.08;  // of stiffness, at a fixed depth (Tan 1995)

HapticCase over(double round_trip, double stiffness) {
  HapticCase out;
  out.stiffness = stiffness;
  out.line = {round_trip, 0.02, 0.05};
  return out;
}

class EveryDelay : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(RoundTrips, EveryDelay, testing::Values(0, 0.02, 0.05, 0.1, 0.2));

TEST_P(EveryDelay, TissueToThreeKilonewtonsAMetreIsStableAndPassive) {
  for (const double stiffness : {30., 100., 300., 1000., 3000.})
    for (const HandImpedance& hand : {light_hand, medium_hand}) {
      HapticCase test = over(GetParam(), stiffness);
      test.hand = hand;
      const HapticResult result = run(ours, test);
      EXPECT_TRUE(result.finite);
      EXPECT_LT(result.ripple, still) << stiffness;
      EXPECT_GT(result.least_energy, passive) << stiffness;
    }
}

// Means over depths that differ by parts of an encoder's step: a single one may be off by half of it.
TEST_P(EveryDelay, StiffnessIsFeltAsItIs) {
  constexpr int depths = 5;
  for (const double stiffness : {30., 100., 300., 1000., 3000.}) {
    double still_hand = 0, swinging = 0;
    for (int k = 0; k < depths; ++k) {
      HapticCase test = over(GetParam(), stiffness);
      test.hand = medium_hand;
      test.depth *= 1 + 0.02 * k;
      still_hand += run(ours, test).felt / depths;
      test.frequency = 2;
      swinging += run(ours, test).felt_swinging / depths;
    }
    EXPECT_NEAR(still_hand, 1, 0.05) << stiffness;
    EXPECT_NEAR(swinging, 1, just_noticed) << stiffness;
  }
}

TEST(HapticLoop, ForcesOverTheNetAreUnstableWhereItIsNot) {
  EXPECT_GT(run(over_the_net, over(0.1, 300)).ripple, still);
  EXPECT_GT(run(stiff_surface, over(0.1, 100)).ripple, still);
}

TEST(HapticLoop, AWrongEstimateIsStableToo) {
  for (const double times : {0.5, 1.5}) {
    const HapticScheme wrong = {"wrong", "", -times, true, {}};
    for (const double stiffness : {100., 1000.}) {
      const HapticResult result = run(wrong, over(0.1, stiffness));
      EXPECT_LT(result.ripple, still) << times << " " << stiffness;
      EXPECT_NEAR(result.felt, 1, 0.06) << times << " " << stiffness;
    }
  }
}

TEST(HapticLoop, ContactIsFeltAtOnceHoweverFarTheServerIs) {
  for (const double round_trip : {0., 0.2}) EXPECT_LT(run(ours, over(round_trip, 1000)).onset, 0.004);
}

TEST(HapticLoop, FreeAirWeighsNothing) {
  HapticCase test;
  test.free = true;
  EXPECT_EQ(run(ours, test).drag, 0);
}

/// A loop that touches a wall of 500 N/m at 2 mm, its ramp over.
struct Pressed {
  HapticLoop loop{omni_limits()};
  std::vector<ContactPlane> planes = std::vector<ContactPlane>(1);
  ArmReading reading;
  double t = 0;
  Pressed() {
    planes[0].id = 1;
    planes[0].stiffness = planes[0].tangential = 500;
    reading.valid = true;
    reading.stylus.p = {0, -0.002, 0};
    for (int k = 0; k < 1000; ++k) go_on();
  }
  Vec3 go_on(bool receives = true) {
    t += 1e-3;
    if (receives && static_cast<int>(t * 1000) % 16 == 0) loop.take(planes, t);
    return loop.cycle(reading, t);
  }
};

TEST(HapticLoop, GoesLimpSmoothlyWhenTheServerFallsSilent) {
  Pressed pressed;
  EXPECT_NEAR(pressed.loop.force().y(), 1, 1e-6);
  double before = 1;
  int cycles = 0;
  while (pressed.go_on(false).y() > 0 && cycles < 1000) {
    EXPECT_GE(pressed.loop.force().y(), before - 0.05);
    before = pressed.loop.force().y();
    ++cycles;
  }
  EXPECT_LT(cycles, 115) << "three messages of waiting, then fifty milliseconds";
  for (int k = 0; k < 400; ++k) pressed.go_on();
  EXPECT_NEAR(pressed.loop.force().y(), 1, 1e-6) << "and is back with it";
}

TEST(HapticLoop, NoForceBeforeAPoseIsKnownNorAfterItIsLost) {
  Pressed pressed;
  pressed.reading.valid = false;
  for (int k = 0; k < 60; ++k) pressed.go_on();
  EXPECT_NEAR(pressed.loop.force().norm(), 0, 1e-9);
  pressed.reading.valid = true;
  EXPECT_LT(pressed.go_on().norm(), 0.02) << "then it comes slowly";
}

TEST(HapticLoop, APoseThatIsNoNumberIsNone) {
  Pressed pressed;
  pressed.reading.stylus.p.x() = std::numeric_limits<double>::quiet_NaN();
  for (int k = 0; k < 60; ++k) EXPECT_TRUE(pressed.go_on().allFinite());
  EXPECT_NEAR(pressed.loop.force().norm(), 0, 1e-9);
}

/// Lets a loop whose clock jumped by `jump` s go on: its force fades, then comes again, and never by a step.
void expect_a_new_beginning(double jump) {
  Pressed pressed;
  pressed.t += jump;
  double before = 1, least = 1;
  for (int k = 0; k < 600; ++k) {
    const double force = pressed.go_on().y();
    EXPECT_NEAR(force, before, 0.05);
    before = force;
    least = std::min(least, force);
  }
  EXPECT_LT(least, 0.25) << "what acted is gone in 50 ms, when a sixth of the new has come";
  EXPECT_NEAR(before, 1, 1e-6);
  EXPECT_EQ(pressed.loop.guard().stalls, 2u) << "the start, and this";
}

TEST(HapticLoop, AStalledLoopBeginsAtNothing) {
  expect_a_new_beginning(0.03);
}

TEST(HapticLoop, AClockThatJumpsBackIsAStall) {
  expect_a_new_beginning(-0.5);
}

TEST(HapticLoop, APlaneThatFlipsNeitherKicksNorBreaks) {
  Pressed pressed;
  Vec3 last = pressed.loop.force();
  for (int k = 0; k < 500; ++k) {
    if (k % 16 == 0) pressed.planes[0].normal *= -1;
    const Vec3 force = pressed.go_on();
    ASSERT_TRUE(force.allFinite());
    ASSERT_LE((force - last).norm(), omni_limits().max_slew * 1e-3 * (1 + 1e-9));
    last = force;
  }
}

TEST(HapticLoop, HugePlanesAreBounded) {
  Pressed pressed;
  pressed.planes[0].stiffness = max_plane_stiffness;
  pressed.planes[0].force = {0, max_plane_force, 0};
  Vec3 last = pressed.loop.force();
  for (int k = 0; k < 500; ++k) {
    const Vec3 force = pressed.go_on();
    ASSERT_LE(force.norm(), omni_limits().peak_force * (1 + 1e-9));
    ASSERT_LE((force - last).norm(), omni_limits().max_slew * 1e-3 * (1 + 1e-9));
    last = force;
  }
}

}  // namespace
}  // namespace prosector
