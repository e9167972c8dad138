// What the server tells a hand of what it holds: a thing's weight, tissue that it pulls, what a tool in it
// presses and cuts. The measure is the force that the physics has on that hand.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/haptics/felt_case.h"
#include "tests/physics/scalpel.h"

namespace prosector::test {
namespace {

/// A hand that an arm moves and that pushes back with all it has.
TickInput moved_to(const Vec3& at) {
  TickInput input = target(at);
  input.targets[0].reaction = 40;
  return input;
}

/// What holds is counted after the tick, contacts as the mean over it: at rest both are the same.
void expect_as_on_the_hand(const FeltCase& c, double share) {
  const Vec3 on_bodies = c.simulation.hands()[0].contact.force;
  EXPECT_GT(on_bodies.norm(), 0.1);
  EXPECT_LT((c.told_force() + on_bodies).norm(), share * on_bodies.norm())
      << c.told_force().transpose() << " told, " << -on_bodies.transpose() << " there";
}

void go(FeltCase& c, Vec3& at, const Vec3& to, int ticks = 60) {
  const Vec3 from = at;
  for (int k = 1; k <= ticks; ++k) c.step(moved_to(from + (to - from) * k / ticks));
  at = to;
}

SceneDesc soft_block() {
  SceneDesc scene;
  scene.soft = {block()};
  scene.soft[0].attach = {{{0, 0, 0}, 0.2, 1e7}};
  scene.soft[0].gravity = false;
  scene.soft[0].youngs_modulus = 20000;
  return scene;
}

TEST(Held, AThingHasItsWeight) {
  SceneDesc scene;
  scene.rigid = {table(), part_body("box", "box", {0.04, 0.1, 0.04}, {0, 0.05, 0}, 2000)};
  FeltCase c(scene);
  Vec3 at(0, 0.12, 0.03);
  c.step(appear(at));
  c.step(event(HandEvent::Kind::grasp, at));
  ASSERT_TRUE(c.simulation.hands()[0].holding);
  go(c, at, {0, 0.25, 0.03});
  for (int k = 0; k < 120; ++k) c.step(moved_to(at));
  EXPECT_NEAR(c.told_force().y(), -0.32 * 9.81, 0.02);
  ASSERT_EQ(c.last.planes.size(), 1u);
  EXPECT_TRUE(c.last.planes[0].holds);
  EXPECT_LT(c.last.planes[0].stiffness, 0.01) << "as heavy wherever it is";
  expect_as_on_the_hand(c, 0.02);
}

TEST(Held, WhatAToolPressesIsFelt) {
  SceneDesc scene = soft_block();
  scene.rigid = {part_body("stick", "box", {0.02, 0.1, 0.02}, {0, 0.125, 0}, 500)};
  FeltCase c(scene);
  Vec3 at(0, 0.15, 0.03);
  c.step(appear(at));
  c.step(event(HandEvent::Kind::grasp, at));
  ASSERT_TRUE(c.simulation.hands()[0].holding);
  go(c, at, at - Vec3(0, 0.02, 0));
  c.settle(moved_to(at));
  expect_as_on_the_hand(c, 0.03);
  EXPECT_GT(c.told_force().y(), 0.5);
  const double told = c.told_stiffness(), before = c.told_force().y();
  go(c, at, at - Vec3(0, 5e-4, 0));
  c.settle(moved_to(at));
  const double slope = (c.told_force().y() - before) / 5e-4;
  EXPECT_NEAR(told / slope, 1, 0.2) << "of " << slope << " N/m";
}

TEST(Held, TissuePullsBackAsItIsPulled) {
  FeltCase c(soft_block());
  Vec3 at(0, 0.08, 0.045);
  c.step(appear(at));
  c.step(event(HandEvent::Kind::grasp, at));
  ASSERT_TRUE(c.simulation.hands()[0].holding);
  go(c, at, at + Vec3(0, 0.003, 0));
  c.settle(moved_to(at));
  expect_as_on_the_hand(c, 0.03);
  EXPECT_LT(c.told_force().y(), -0.3);
  const double told = c.told_stiffness(), before = c.told_force().y();
  go(c, at, at + Vec3(0, 5e-4, 0));
  c.settle(moved_to(at));
  const double slope = (before - c.told_force().y()) / 5e-4;
  EXPECT_NEAR(told / slope, 1, 0.2) << "of " << slope << " N/m";
  EXPECT_TRUE(std::any_of(c.last.planes.begin(), c.last.planes.end(),
                          [](const ContactPlane& plane) { return plane.holds; }));
}

TEST(Held, WhatIsCutHoldsTheBladeUpToItsToughness) {
  FeltCase c(block_and_scalpel());
  Vec3 at = take(c.simulation);
  double most = 0;
  for (int k = 0; k < 80; ++k) {
    at.x() += 0.0016;
    c.step(moved_to(at));
    for (const ContactPlane& plane : c.last.planes) {
      if (!plane.holds || plane.body == scalpel) continue;
      most = std::max(most, -plane.force.x());
      // 10 J/m² times 6 cm of edge, and half as much again where it begins.
      EXPECT_LE(plane.force.norm() + plane.radius * plane.stiffness, 1.5 * 10 * 0.07);
    }
  }
  EXPECT_GT(most, 0.3) << "N, against the stroke";
}

}  // namespace
}  // namespace prosector::test
