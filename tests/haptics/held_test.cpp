// What the server tells a hand of what it holds: a thing's weight, tissue that it pulls, what a tool in it
// presses and cuts. The measure is the force that the physics has on that hand.
#include <gtest/gtest.h>

#include <algorithm>

#include "client/haptics/plane_set.h"
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
  EXPECT_LT((c.reported_force() + on_bodies).norm(), share * on_bodies.norm())
      << c.reported_force().transpose() << " told, " << -on_bodies.transpose() << " there";
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
  scene.soft[0].material.youngs_modulus = 20000;
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
  EXPECT_NEAR(c.reported_force().y(), -0.32 * 9.81, 0.02);
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
  EXPECT_GT(c.reported_force().y(), 0.5);
  const double reported = c.reported_stiffness(), before = c.reported_force().y();
  go(c, at, at - Vec3(0, 5e-4, 0));
  c.settle(moved_to(at));
  const double slope = (c.reported_force().y() - before) / 5e-4;
  EXPECT_NEAR(reported / slope, 1, 0.2) << "of " << slope << " N/m";
}

/// What the arm renders of the told planes where the hand is as the arm has it, N.
Vec3 rendered(const FeltCase& c, const Vec3& at) {
  PlaneSet set;
  set.take(c.last.planes, 0);
  Vec3 force;
  for (int k = 0; k < 100; ++k) force = set.advance({at, Quat::Identity()}, {}, at, 1e-3).wrench.force;
  return force;
}

TEST(Held, AToolOnATableIsAHardSurface) {
  SceneDesc scene;
  scene.rigid = {table(), part_body("stick", "box", {0.02, 0.1, 0.02}, {0, 0.05, 0}, 500)};
  FeltCase c(scene);
  Vec3 at(0, 0.08, 0.03);
  c.step(appear(at));
  c.step(event(HandEvent::Kind::grasp, at));
  ASSERT_TRUE(c.simulation.hands()[0].holding);
  c.settle(moved_to(at));
  const double before = rendered(c, at).y();
  go(c, at, at - Vec3(0, 1e-3, 0));
  c.settle(moved_to(at));
  EXPECT_NEAR(rendered(c, at).y() - before, 2, 0.1) << "2 kN/m, whatever the solver's contact has";
  go(c, at, at + Vec3(0, 0.02, 0));
  c.settle(moved_to(at));
  EXPECT_NEAR(rendered(c, at).y(), -0.02 * 9.81, 0.01) << "lifted, it has its weight and no more";
}

constexpr BodyId right_bar = 1, below = 5;
/// A plate with a hole of 24 mm, and below it a block of tissue.
SceneDesc port_over_a_block() {
  SceneDesc scene = soft_block();
  const auto bar = [&](const char* name, const Vec3& size, const Vec3& place) {
    scene.rigid.push_back(part_body(name, "box", size, place));
    scene.rigid.back().fixed = true;
  };
  bar("left", {0.05, 0.02, 0.2}, {-0.037, 0.15, 0});
  bar("right", {0.05, 0.02, 0.2}, {0.037, 0.15, 0});
  bar("front", {0.024, 0.02, 0.05}, {0, 0.15, 0.037});
  bar("back", {0.024, 0.02, 0.05}, {0, 0.15, -0.037});
  scene.rigid.push_back(part_body("rod", "box", {0.02, 0.2, 0.02}, {0, 0.17, 0}, 500));
  return scene;
}

TEST(Held, AToolThroughAPortFeelsThePortAtItsSideAndTissueAtItsTip) {
  FeltCase c(port_over_a_block());
  Vec3 at(0, 0.25, 0.03);
  c.step(appear(at));
  c.step(event(HandEvent::Kind::grasp, at));
  ASSERT_TRUE(c.simulation.hands()[0].holding);
  c.settle(moved_to(at));
  const double weight = 0.04 * 9.81;
  EXPECT_NEAR((rendered(c, at) - Vec3(0, -weight, 0)).norm(), 0, 0.02)
      << "free in the port, above the tissue";
  for (const double side : {0.003, 0.005, 0.008}) {
    go(c, at, Vec3(side, at.y(), at.z()));
    c.settle(moved_to(at));
    expect_as_on_the_hand(c, 0.05);
    // The port is 0.1 m from the grip, so that a push at it turns the rod in the hand: it is no hard wall.
    EXPECT_NEAR(-rendered(c, at).x() / (side - 0.002), 430, 40) << side;
  }
  go(c, at, at - Vec3(0, 0.014, 0));
  c.settle(moved_to(at));
  expect_as_on_the_hand(c, 0.05);
  const auto feels = [&](BodyId body) {
    return std::any_of(c.last.planes.begin(), c.last.planes.end(),
                       [&](const ContactPlane& p) { return p.body == body && p.force.norm() > 0.3; });
  };
  EXPECT_TRUE(feels(right_bar)) << "the port's side";
  EXPECT_TRUE(feels(below)) << "and tissue at the tip";
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
  EXPECT_LT(c.reported_force().y(), -0.3);
  const double reported = c.reported_stiffness(), before = c.reported_force().y();
  go(c, at, at + Vec3(0, 5e-4, 0));
  c.settle(moved_to(at));
  const double slope = (before - c.reported_force().y()) / 5e-4;
  EXPECT_NEAR(reported / slope, 1, 0.2) << "of " << slope << " N/m";
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
