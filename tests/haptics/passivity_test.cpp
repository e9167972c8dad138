// The energy that a hand puts in and gets back, and what is done when it gets too much.
#include <gtest/gtest.h>

#include <cmath>

#include "client/haptics/passivity.h"
#include "common/rotation.h"
#include "tests/haptics/haptic_case.h"

namespace prosector {
namespace {

Pose at(const Vec3& place) {
  return {place, Quat::Identity()};
}

Vec3 damped(Passivity& passivity, const Vec3& force, const Vec3& velocity) {
  return passivity.damp({force, Vec3::Zero()}, {velocity, Vec3::Zero()}, dt).force;
}

TEST(Passivity, CountsWhatForcesThatAreHeldDo) {
  Passivity passivity;
  passivity.observe(Pose{}, 0, 0, dt);
  passivity.applied({{0, 2, 0}, Vec3::Zero()});
  passivity.observe(at({0, -0.003, 0}), 1, 0, dt);  // pressed in against 2 N
  EXPECT_NEAR(passivity.book().taken, 0.006, 1e-12);
  passivity.applied({{0, 1, 0}, Vec3::Zero()});
  passivity.observe(Pose{}, 1, 0, dt);
  EXPECT_NEAR(passivity.book().given, 0.003, 1e-12);
  EXPECT_NEAR(passivity.level(), 0.003, 1e-12);
}

TEST(Passivity, CountsTurnsAgainstATorque) {
  Passivity passivity;
  passivity.observe(Pose{}, 0, 0, dt);
  passivity.applied({Vec3::Zero(), {0, 0, 0.2}});
  passivity.observe({Vec3::Zero(), rotated_by({0, 0, -0.05})}, 1, 0, dt);
  EXPECT_NEAR(passivity.book().taken, 0.01, 1e-12);
  passivity.observe(Pose{}, 0, 0, dt);
  EXPECT_NEAR(passivity.book().given, 0.01, 1e-12);
  passivity.applied({Vec3::Zero(), {0, 0, 0.2}});
  passivity.observe({Vec3::Zero(), rotated_by({0, 0, 0.01})}, 0, 0,
                    dt);  // it gave 2 mJ that nobody had put in
  const Vec3 spin(0, 0, 2);
  Vec3 torque(0, 0, 0.2);
  for (int k = 0; k < 10; ++k)
    torque = passivity.damp({Vec3::Zero(), {0, 0, 0.2}}, {Vec3::Zero(), spin}, dt).torque;
  EXPECT_LT(torque.z(), 0.15) << "it is damped";
}

TEST(Passivity, DampsOnlyWhereEnergyIsMissing) {
  Passivity passivity;
  passivity.observe(Pose{}, 0, 0, dt);
  const Vec3 force(0, 1, 0), velocity(0, 0.1, 0);
  EXPECT_EQ(damped(passivity, force, velocity), force);
  passivity.applied({force, Vec3::Zero()});
  passivity.observe(at({0, 0.0001, 0}), 0, 0, dt);  // it gave 0.1 mJ that nobody had put in
  double before = 0, all = 0;                       // N
  for (int k = 0; k < 10; ++k) {
    all = 1 - damped(passivity, force, velocity).y();
    EXPECT_GE(all, before);
    EXPECT_LT(all - before, 0.5) << "it sets in without a jolt";
    before = all;
  }
  EXPECT_NEAR(all, 1, 1e-12) << "0.1 mJ at 0.1 m/s in a cycle takes 1 N";
  EXPECT_EQ(damped(passivity, force, Vec3::Zero()), force) << "nothing moves: nothing to damp";
}

TEST(Passivity, WhatMovingSurfacesGiveIsNotMissing) {
  Passivity passivity;
  passivity.observe(Pose{}, 0, 0, dt);
  passivity.applied({{0, 1, 0}, Vec3::Zero()});
  passivity.observe(at({0, 0.0001, 0}), 0, 0.1, dt);
  EXPECT_GE(passivity.level(), -1e-15);
}

TEST(Passivity, WhatWasSpentLongAgoIsNoSaving) {
  Passivity passivity;
  passivity.observe(Pose{}, 0, 0, dt);
  Vec3 place = Vec3::Zero();
  for (int k = 0; k < 10000; ++k) {
    passivity.applied({{0, 1, 0}, Vec3::Zero()});
    place.y() -= 0.001;
    passivity.observe(at(place), 0.01, 0, dt);
  }
  EXPECT_LT(passivity.level(), 0.0121) << "what springs hold, and little more";
}

}  // namespace
}  // namespace prosector
