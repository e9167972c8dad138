// What a hand feels of one plane, and of a message's planes together.
#include <gtest/gtest.h>

#include "client/haptics/plane_set.h"
#include "tests/haptics/haptic_case.h"

namespace prosector {
namespace {

ContactPlane wall(double stiffness = 500) {
  ContactPlane plane;
  plane.id = 1;
  plane.normal = Vec3::UnitY();
  plane.stiffness = plane.tangential = stiffness;
  plane.friction = 0.5;
  return plane;
}

Pose at(double x, double y) {
  return {Vec3(x, y, 0), Quat::Identity()};
}

Vec3 force_of(PlaneSet& set, const Pose& hand) {
  return set.advance(hand, {}, hand.p, dt).wrench.force;
}

TEST(PlaneContact, PushesByStiffnessTimesDepthAndOnlyOutwards) {
  PlaneContact contact(wall(), 0);
  EXPECT_NEAR(contact.advance(at(0, -0.002), HandMotion{}, dt).force.y(), 1, 1e-12);
  EXPECT_EQ(contact.advance(at(0, 0.001), HandMotion{}, dt).force, Vec3::Zero());
}

TEST(PlaneContact, WhatIsHeldPullsAsWell) {
  ContactPlane plane = wall();
  plane.holds = true;
  plane.force = {0, -2, 0};
  plane.radius = 0.003;
  PlaneContact contact(plane, 0);
  EXPECT_NEAR(contact.advance(at(0, 0), HandMotion{}, dt).force.y(), -2, 1e-12);
  EXPECT_NEAR(contact.advance(at(0, 0.002), HandMotion{}, dt).force.y(), -3, 1e-12);
}

TEST(PlaneContact, WhatIsHeldYieldsBeyondItsRadius) {
  ContactPlane plane = wall();
  plane.holds = true;
  plane.force = {0, -2, 0};
  plane.radius = 0.001;  // half a newton more
  PlaneContact contact(plane, 0);
  EXPECT_NEAR(contact.advance(at(0, 0.02), HandMotion{}, dt).force.norm(), 2.5, 1e-12);
  EXPECT_NEAR(contact.advance(at(0.05, 0), HandMotion{}, dt).force.norm(), 2.5, 1e-12);
}

TEST(PlaneContact, AWeightIsTheSameEverywhere) {
  ContactPlane plane = wall(0);
  plane.holds = true;
  plane.force = {0, -2, 0};
  PlaneContact contact(plane, 0);
  for (const double y : {0., 0.3, -0.3})
    EXPECT_EQ(contact.advance(at(0.1, y), HandMotion{}, dt).force, plane.force);
}

TEST(PlaneContact, FrictionHoldsAndThenSlidesAtItsCoefficient) {
  PlaneContact contact(wall(), 0);
  contact.advance(at(0, -0.002), HandMotion{}, dt);  // 1 N
  EXPECT_NEAR(contact.advance(at(0.0005, -0.002), HandMotion{}, dt).force.x(), -0.25, 1e-9);
  EXPECT_NEAR(contact.advance(at(0.01, -0.002), HandMotion{}, dt).force.x(), -0.5, 1e-9);
  // It slid: back by a little is the way back from there, not from where it was first touched.
  EXPECT_NEAR(contact.advance(at(0.0095, -0.002), HandMotion{}, dt).force.x(), -0.25, 1e-9);
}

TEST(PlaneContact, ANewerPlaneTakesOverWithoutAJump) {
  PlaneContact contact(wall(), 0);
  const Pose hand = at(0, -0.002);
  contact.advance(hand, HandMotion{}, dt);
  ContactPlane newer = wall(800);
  newer.point.y() = 0.001;
  contact.renew(newer, 0.02);
  double before = 1, largest = 0;
  for (int k = 0; k < 20; ++k) {
    const double force = contact.advance(hand, HandMotion{}, dt).force.y();
    largest = std::max(largest, std::abs(force - before));
    before = force;
  }
  EXPECT_NEAR(before, 800 * 0.003, 1e-9);
  EXPECT_NEAR(largest, (2.4 - 1) / 20, 1e-9);
}

TEST(PlaneContact, ASurfaceThatBeginsToMoveBringsNoJolt) {
  ContactPlane plane = wall();
  plane.damping = 10;
  PlaneContact contact(plane, 0);
  const Pose hand = at(0, -0.002);
  double before = contact.advance(hand, HandMotion{}, dt).force.y();
  plane.velocity = {0, 0.1, 0};  // a newton by damping
  contact.renew(plane, 0.02);
  for (int k = 0; k < 20; ++k) {
    const double force = contact.advance(hand, HandMotion{}, dt).force.y();
    EXPECT_LT(std::abs(force - before), 0.11) << k;
    before = force;
  }
  EXPECT_NEAR(before, 1 + 500 * 0.1 * 0.02 + 1, 0.01);
}

TEST(PlaneContact, ASurfaceThatMovesTakesItsForceAlong) {
  ContactPlane plane = wall();
  plane.velocity = {0, 0.1, 0};
  PlaneContact contact(plane, 0);
  PlaneForce felt;
  for (int k = 0; k < 50; ++k) felt = contact.advance(at(0, 0), HandMotion{}, dt);
  EXPECT_NEAR(felt.force.y(), 500 * 0.1 * 0.05, 1e-9);
  EXPECT_NEAR(felt.power, felt.force.y() * 0.1, 1e-9);
  for (int k = 0; k < 1000; ++k) felt = contact.advance(at(0, 0), HandMotion{}, dt);
  EXPECT_NEAR(felt.force.y(), 500 * 0.1 * 0.1, 1e-9) << "goes on for no longer than is known";
}

TEST(PlaneContact, StiffnessIsTheSlopeOfItsForce) {
  for (const bool slides : {false, true}) {
    PlaneContact contact(wall(), 0);
    contact.advance(at(0, -0.002), HandMotion{}, dt);
    const double x = slides ? 0.01 : 0.0002, step = 1e-6;
    const PlaneForce here = contact.advance(at(x, -0.002), HandMotion{}, dt);
    PlaneContact deeper = contact, further = contact;
    const Vec3 down = (deeper.advance(at(x, -0.002 - step), HandMotion{}, dt).force - here.force) / step;
    const Vec3 on = (further.advance(at(x + step, -0.002), HandMotion{}, dt).force - here.force) / step;
    EXPECT_NEAR(down.y(), here.stiffness(1, 1), 1e-6);
    EXPECT_NEAR(on.x(), -here.stiffness(0, 0), 1e-6);
    EXPECT_EQ(here.stiffness(0, 0) == 0, slides);
  }
  PlaneContact away(wall(), 0);
  EXPECT_EQ(away.advance(at(0, 0.001), HandMotion{}, dt).stiffness, Mat3::Zero());
}

TEST(PlaneSet, APlaneThatIsNotToldAnyMoreFades) {
  PlaneSet set;
  const Pose hand = at(0, -0.002);
  const std::vector<ContactPlane> one = {wall()};
  for (int k = 0; k < 10; ++k) set.take(one, k / 60.);
  double force = 0;
  for (int k = 0; k < 60; ++k) force = force_of(set, hand).y();
  EXPECT_NEAR(force, 1, 1e-9);
  set.take({}, 10 / 60.);
  double before = force;
  for (int k = 0; k < 30; ++k) {
    force = force_of(set, hand).y();
    EXPECT_LE(force, before);
    EXPECT_GT(force, before - 0.1) << "by a step";
    before = force;
  }
  EXPECT_EQ(force, 0);
  EXPECT_FALSE(set.touches());
}

TEST(PlaneSet, SilenceIsNoticedWithinAFewMessages) {
  PlaneSet set;
  EXPECT_TRUE(set.stale(0)) << "before the first message";
  double t = 0;
  for (; t < 1; t += 1. / 60) set.take({}, t);
  EXPECT_FALSE(set.stale(t));
  EXPECT_TRUE(set.stale(t + 0.1));
}

TEST(PlaneSet, ARepeatedMessageIsASignOfLifeAndNothingElse) {
  PlaneSet set;
  const std::vector<ContactPlane> one = {wall()};
  double t = 0;
  for (; t < 1; t += 0.1) {
    set.take(one, t);
    for (double again = 0.005; again < 0.099; again += 0.005) {
      set.repeat_received(t + again);
      EXPECT_FALSE(set.stale(t + again + 0.015));
    }
  }
  EXPECT_TRUE(set.stale(t + 0.03)) << "messages a tenth of a second apart, their repeats 5 ms";
  double force = 0;
  for (int k = 0; k < 60; ++k) force = force_of(set, at(0, -0.002)).y();
  EXPECT_NEAR(force, 1, 1e-9);
}

TEST(PlaneSet, TwoPlanesThatFaceEachOtherAddUp) {
  PlaneSet set;
  ContactPlane above = wall();
  above.id = 2;
  above.normal = -Vec3::UnitY();
  above.point.y() = 0.001;
  const std::vector<ContactPlane> both = {wall(), above};
  const Pose hand = at(0, -0.001);
  set.take(both, 0);
  Vec3 force;
  for (int k = 0; k < 100; ++k) force = force_of(set, hand);
  EXPECT_NEAR(force.y(), 0.5, 1e-9);
}

TEST(PlaneSet, APlaneAtAToolsTipTurnsTheHand) {
  PlaneSet set;
  ContactPlane tip = wall();
  tip.arm = {0, 0, -0.1};
  tip.damping = 10;
  set.take({&tip, 1}, 0);
  const Pose hand = at(0, -0.002);
  const HandMotion turning{Vec3::Zero(), {0.5, 0, 0}};  // the tip rises by 5 cm/s
  FeltWrench felt;
  for (int k = 0; k < 100; ++k) felt = set.advance(hand, turning, hand.p, dt);
  EXPECT_NEAR(felt.wrench.force.y(), 1 - 0.5, 1e-9) << "damped by how fast the tip moves";
  EXPECT_NEAR((felt.wrench.torque - Vec3(0.1 * 0.5, 0, 0)).norm(), 0, 1e-9);
  EXPECT_NEAR(felt.torsion, 500 * 0.01, 1e-9);
  felt = set.advance(hand, turning, hand * tip.arm, dt);
  EXPECT_NEAR(felt.wrench.torque.norm(), 0, 1e-12) << "about the tip there is none";
}

}  // namespace
}  // namespace prosector
