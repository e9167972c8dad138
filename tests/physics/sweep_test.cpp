// Fast rigid bodies are swept along their path within a tick.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "server/physics/mechanics/rigid/rigid_world.h"
#include "tests/physics/rigid_setup.h"

namespace prosector::test {
namespace {

using collision::ShapeKind;
using collision::ShapePart;

constexpr double h = 1.0 / 60;

void tick(rigid::RigidWorld& world) {
  world.detect(h);
  world.find_islands({}, {});
  world.solve(h);
  world.integrate(h);
}

/// A body, with half of its least extent, m.
struct Thrown {
  const char* name;
  std::vector<ShapePart> parts;
  double half;
};

std::vector<Thrown> thrown_bodies() {
  return {{"ball of 2 mm", {rigid_part(ShapeKind::sphere, {0.002, 0, 0})}, 0.002},
          {"ball of 20 mm", {rigid_part(ShapeKind::sphere, {0.02, 0, 0})}, 0.02},
          {"box", {rigid_part(ShapeKind::box, {0.03, 0.005, 0.02})}, 0.005},
          {"capsule", {rigid_part(ShapeKind::capsule, {0.004, 0.05, 0})}, 0.004},
          {"two balls",
           {rigid_part(ShapeKind::sphere, {0.01, 0, 0}, {-0.05, 0, 0}),
            rigid_part(ShapeKind::sphere, {0.01, 0, 0}, {0.05, 0, 0})},
           0.01}};
}

TEST(Sweep, FastBodiesDoNotPassPlates) {
  for (const Thrown& body : thrown_bodies())
    for (const double plate : {0.0005, 0.0025, 0.02})
      for (const double speed : {0.5, 2.0, 7.0, 30.0, 100.0})
        for (const double start : {0.3, 0.317, 0.3333}) {  // m above: other remainders of the last tick
          SCOPED_TRACE(testing::Message()
                       << body.name << ", plate " << plate << ", " << speed << " m/s, " << start);
          rigid::RigidWorld world({0, 0, 0});
          world.add(rigid_setup({rigid_part(ShapeKind::box, {0.5, plate, 0.5})}, 0), {});
          const std::size_t slot = world.add(rigid_setup(body.parts, 0.1),
                                             rigid_motion({0.01, start, 0.02}, {0.1 * speed, -speed, 0}));
          double greatest = 0, lowest = start;
          for (int k = 0; k < 60; ++k) {
            tick(world);
            greatest = std::max(greatest, world.motion(slot).linear_velocity.norm());
            if (world.motion(slot).pose.p.x() < 0.45)
              lowest = std::min(lowest, world.motion(slot).pose.p.y());
          }
          EXPECT_GT(lowest, plate);
          EXPECT_LE(greatest, 1.01 * std::hypot(1, 0.1) * speed);
        }
}

TEST(Sweep, TumblingBodiesDoNotPassAPlate) {
  for (const Thrown& body : {Thrown{"box", {rigid_part(ShapeKind::box, {0.01, 0.01, 0.01})}, 0.01},
                             Thrown{"capsule", {rigid_part(ShapeKind::capsule, {0.01, 0.01, 0})}, 0.01}})
    for (const double speed : {5.0, 19.0, 60.0, 200.0})
      for (int k = 0; k < 6; ++k) {
        SCOPED_TRACE(testing::Message() << body.name << ", " << speed << " m/s, " << k);
        rigid::RigidWorld world({0, -9.81, 0});
        world.add(rigid_setup({rigid_part(ShapeKind::box, {6, 0.005, 6})}, 0), {});
        rigid::RigidMotion start = rigid_motion({0.01, 0.5 + k * speed / 360, 0}, {0, -speed, 0});
        start.pose.q = Quat(Eigen::AngleAxisd(0.3 + k, Vec3(1, 2, 3).normalized()));
        const std::size_t slot = world.add(rigid_setup(body.parts, 0.1), start);
        for (int t = 0; t < 60; ++t) tick(world);
        EXPECT_GT(world.motion(slot).pose.p.y(), 0);
      }
}

TEST(Sweep, StopsWhereTheBodyMeetsThePlate) {
  for (const double speed : {5.0, 20.0, 80.0}) {
    rigid::RigidWorld world({0, 0, 0});
    world.add(rigid_setup({rigid_part(ShapeKind::box, {0.5, 0.0025, 0.5})}, 0), {});
    const std::size_t slot = world.add(rigid_setup({rigid_part(ShapeKind::sphere, {0.01, 0, 0})}, 0.1),
                                       rigid_motion({0, 0.5, 0}, {0, -speed, 0}));
    for (int k = 0; k < 30; ++k) tick(world);
    EXPECT_NEAR(world.motion(slot).pose.p.y(), 0.0125, 0.0005) << speed;
  }
}

TEST(Sweep, BodiesThatMoveTogetherDoNotStopEachOther) {
  rigid::RigidWorld world({0, 0, 0});
  const std::vector<ShapePart> box = {rigid_part(ShapeKind::box, {0.005, 0.005, 0.005})};
  for (int k = 0; k < 5; ++k) world.add(rigid_setup(box, 0.1), rigid_motion({0, 0.011 * k, 0}, {3, -40, 0}));
  for (int k = 0; k < 60; ++k) tick(world);
  for (std::size_t k = 0; k < 5; ++k) {
    const Vec3 meant(3, 0.011 * static_cast<double>(k) - 40, 0);
    EXPECT_NEAR((world.motion(k).pose.p - meant).norm(), 0, 1e-3) << k;
  }
}

TEST(Sweep, BodyThatSlidesFastKeepsItsSpeed) {
  rigid::RigidWorld world({0, -9.81, 0});
  world.add(rigid_setup({rigid_part(ShapeKind::box, {3, 0.01, 0.5})}, 0), {});
  const std::size_t slot = world.add(rigid_setup({rigid_part(ShapeKind::box, {0.01, 0.01, 0.01})}, 0.1),
                                     rigid_motion({0, 0.0205, 0}, {10, 0, 0}));
  for (int k = 0; k < 15; ++k) tick(world);
  EXPECT_NEAR(world.motion(slot).pose.p.x(), 2.5, 0.01);
}

TEST(Sweep, FastBodiesThatMeetDoNotPassEachOther) {
  for (const double speed : {2.0, 15.0, 60.0}) {
    rigid::RigidWorld world({0, 0, 0});
    const std::vector<ShapePart> ball = {rigid_part(ShapeKind::sphere, {0.01, 0, 0})};
    const std::size_t left = world.add(rigid_setup(ball, 0.1), rigid_motion({-0.37, 0, 0}, {speed, 0, 0})),
                      right = world.add(rigid_setup(ball, 0.1), rigid_motion({0.42, 0, 0}, {-speed, 0, 0}));
    for (int k = 0; k < 60; ++k) {
      tick(world);
      ASSERT_LT(world.motion(left).pose.p.x(), world.motion(right).pose.p.x()) << speed << ", tick " << k;
    }
    EXPECT_NEAR((world.motion(left).linear_velocity + world.motion(right).linear_velocity).norm(), 0,
                1e-3 * speed);
  }
}

TEST(Sweep, AbsurdVelocitiesEndTheTick) {
  for (const double speed : {1e6, 1e30, std::numeric_limits<double>::infinity(), std::nan("")}) {
    rigid::RigidWorld world({0, 0, 0});
    world.add(rigid_setup({rigid_part(ShapeKind::box, {0.5, 0.0025, 0.5})}, 0), {});
    const std::size_t slot = world.add(rigid_setup({rigid_part(ShapeKind::sphere, {0.001, 0, 0})}, 0.1),
                                       rigid_motion({0, 0.5, 0}, {0, 0, 0}));
    world.detect(h);
    world.find_islands({}, {});
    world.solve(h);
    world.set_velocity(slot, {0, -speed, 0}, Vec3::Zero());
    world.integrate(h);
    EXPECT_TRUE(world.motion(slot).pose.p.allFinite() || !(speed < 1e10));
  }
}

}  // namespace
}  // namespace prosector::test
