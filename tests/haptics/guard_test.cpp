// What stands between any force and a hand.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "client/haptics/force_guard.h"
#include "tests/haptics/haptic_case.h"

namespace prosector {
namespace {

/// A guard whose ramp is over.
ForceGuard ready() {
  ForceGuard guard(force_bounds(omni_limits()));
  for (int k = 0; k < 1000; ++k) guard.pass(Vec3::Zero(), true, false, dt);
  return guard;
}

TEST(ForceGuard, LetsForceComeSlowlyAfterAStart) {
  ForceGuard guard(force_bounds(omni_limits()));
  EXPECT_LT(guard.pass({1, 0, 0}, true, false, dt).norm(), 0.01);
  Vec3 force;
  for (int k = 0; k < 400; ++k) force = guard.pass({1, 0, 0}, true, false, dt);
  EXPECT_NEAR(force.x(), 1, 1e-12);
}

TEST(ForceGuard, KeepsDirectionAtThePeak) {
  ForceGuard guard = ready();
  Vec3 force;
  for (int k = 0; k < 50; ++k) force = guard.pass({30, 40, 0}, true, false, dt);
  EXPECT_NEAR(force.norm(), omni_limits().peak_force, 1e-9);
  EXPECT_NEAR(force.y() / force.x(), 4. / 3, 1e-9);
  EXPECT_GT(guard.counts().saturated, 0u);
}

TEST(ForceGuard, WhatLastsEndsAtWhatMotorsBear) {
  ForceGuard guard = ready();
  Vec3 force;
  for (int k = 0; k < 60000; ++k) force = guard.pass({0, 3, 0}, true, false, dt);
  EXPECT_LT(force.y(), 1.1 * omni_limits().continuous_force);
  EXPECT_GT(force.y(), 0.8 * omni_limits().continuous_force);
}

TEST(ForceGuard, AHotMotorGetsNoMoreThanItBears) {
  ForceGuard guard = ready();
  Vec3 force;
  for (int k = 0; k < 50; ++k) force = guard.pass({0, 3, 0}, true, true, dt);
  EXPECT_NEAR(force.y(), omni_limits().continuous_force, 1e-9);
}

TEST(ForceGuard, FadesWithinFiftyMilliseconds) {
  ForceGuard guard = ready();
  Vec3 force;
  for (int k = 0; k < 50; ++k) force = guard.pass({2, 0, 0}, true, false, dt);
  double before = force.x();
  for (int k = 0; k < 50; ++k) {
    force = guard.pass({2, 0, 0}, false, false, dt);
    EXPECT_LE(force.x(), before);
    EXPECT_GE(force.x(), before - 0.1);
    before = force.x();
  }
  EXPECT_NEAR(force.x(), 0, 1e-9);
}

TEST(ForceGuard, ALateCycleChangesTheForceNoMoreThanAnEighth) {
  for (const double late : {0.003, 0.012, 0.02}) {
    ForceGuard guard = ready();
    for (int k = 0; k < 50; ++k) guard.pass({2, 0, 0}, true, false, dt);
    for (double before = 2, force = 2; force > 0; before = force) {
      force = guard.pass({2, 0, 0}, false, false, late).x();
      EXPECT_LE(before - force, 2. / 8) << late;
    }
    EXPECT_LE(guard.pass({2, 0, 0}, true, false, late).x(), 2. / 8) << late;
  }
}

TEST(ForceGuard, WhateverIsAskedForceAndSlewStayBounded) {
  ForceGuard guard = ready();
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> exponent(-3, 12), sign(-1, 1);
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  Vec3 last = Vec3::Zero();
  for (int k = 0; k < 20000; ++k) {
    Vec3 wanted(sign(random), sign(random), sign(random));
    wanted *= std::pow(10, exponent(random));
    if (k % 17 == 0) wanted.y() = nan;
    if (k % 23 == 0) wanted.z() = inf;
    const Vec3 force = guard.pass(wanted, k % 5 != 0, k % 7 == 0, dt);
    ASSERT_TRUE(force.allFinite());
    ASSERT_LE(force.norm(), omni_limits().peak_force * (1 + 1e-9));
    ASSERT_LE((force - last).norm(), omni_limits().max_slew * dt * (1 + 1e-9));
    last = force;
  }
  EXPECT_GT(guard.counts().not_finite, 0u);
}

}  // namespace
}  // namespace prosector
