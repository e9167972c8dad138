// The three stages together.

#include "tests/collision/reference/collision_world.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "common/error.h"
#include "tests/collision/shapes.h"

namespace prosector {
namespace {

using namespace test;

constexpr double margin = 0.002;
constexpr std::array fidelities = {Fidelity::none, Fidelity::sphere, Fidelity::aabb,
                                   Fidelity::obb,  Fidelity::hull,   Fidelity::mesh};

struct Body {
  std::shared_ptr<const collision::RigidOutline> outline;
  Pose pose;
};

std::vector<Body> heap(int count) {
  Random random(1);
  const auto table = shape_table();
  std::vector<std::shared_ptr<const collision::RigidOutline>> outlines;
  for (const NamedParts& shape : table)
    for (const Fidelity fidelity : fidelities)
      outlines.push_back(std::make_shared<collision::RigidOutline>(shape.parts, fidelity));
  std::vector<Body> out;
  for (int i = 0; i < count; ++i)
    out.push_back({outlines[static_cast<std::size_t>(i * 5) % outlines.size()], random_pose(random, 0.17)});
  return out;
}

bool same(const ObjectTouch& a, const ObjectTouch& b) {
  return a.a == b.a && a.b == b.b && a.gap == b.gap && a.point == b.point && a.normal == b.normal &&
         a.local_a == b.local_a && a.local_b == b.local_b && a.impact == b.impact;
}

TEST(World, FindsWhatLookingAtAllPairsFinds) {
  CollisionWorld world(margin);
  const auto bodies = heap(80);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const auto id =
        world.add(CollisionObject(bodies[i].outline), {.moves = i % 3 != 0, .continuous = false, .mask = {}});
    world.place(id, bodies[i].pose);
  }
  const CollisionReport& report = world.detect();
  std::size_t k = 0;
  for (std::uint32_t a = 0; a < bodies.size(); ++a)
    for (std::uint32_t b = a + 1; b < bodies.size(); ++b) {
      if (a % 3 == 0 && b % 3 == 0) continue;
      const auto found = proximity(world.object(a), world.object(b), margin);
      if (!found) continue;
      ASSERT_LT(k, report.touches.size());
      const ObjectTouch& touch = report.touches[k++];
      EXPECT_EQ(touch.a, a);
      EXPECT_EQ(touch.b, b);
      EXPECT_EQ(touch.gap, found->gap);
      EXPECT_LT(
          (bodies[a].pose * touch.local_a - bodies[b].pose * touch.local_b - touch.gap * touch.normal).norm(),
          1e-9);
      EXPECT_LT(((bodies[a].pose * touch.local_a + bodies[b].pose * touch.local_b) / 2 - touch.point).norm(),
                1e-9);
    }
  EXPECT_EQ(k, report.touches.size());
  EXPECT_GT(k, 100u);
}

TEST(World, ForgetsHowItCameToBe) {
  const auto bodies = heap(60);
  CollisionWorld one(margin), two(margin);
  for (const Body& body : bodies) one.place(one.add(CollisionObject(body.outline)), body.pose);
  // The other comes about in another way.
  Random random(2);
  for (const Body& body : bodies) two.add(CollisionObject(body.outline));
  for (int round = 0; round < 20; ++round) {
    for (std::uint32_t i = 0; i < bodies.size(); ++i) two.place(i, random_pose(random, 0.4));
    two.set_moves(static_cast<std::uint32_t>(round), false);
    two.detect();
    two.set_moves(static_cast<std::uint32_t>(round), true);
  }
  two.remove(7);
  two.add(CollisionObject(bodies[7].outline));
  for (std::uint32_t i = 0; i < bodies.size(); ++i) two.place(i, bodies[i].pose);
  const auto &a = one.detect().touches, &b = two.detect().touches;
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_TRUE(same(a[i], b[i]));
}

TEST(World, FastThingsAreMetWithinTheTick) {
  const std::vector<collision::ShapePart> ball{
      {collision::ShapeKind::sphere, Vec3::Constant(0.01), {}, nullptr}};
  const auto outline = std::make_shared<collision::RigidOutline>(ball, Fidelity::hull);
  for (const bool continuous : {false, true}) {
    CollisionWorld world(margin);
    const auto tool =
        world.add(CollisionObject(outline), {.moves = true, .continuous = continuous, .mask = {}});
    const auto organ = world.add(CollisionObject(organ_mesh(3, {0.12, 0.07, 0.09}), Fidelity::mesh));
    world.place(tool, {{0, 0.4, 0}, Quat::Identity()}, {0, -50, 0});
    const auto& touches = world.detect(1. / 60).touches;
    ASSERT_EQ(touches.size(), continuous ? 1u : 0u);
    if (!continuous) continue;
    const ObjectTouch& touch = touches.front();
    ASSERT_TRUE(touch.impact);
    EXPECT_GT(*touch.impact, 0.006);
    EXPECT_LT(*touch.impact, 0.0075);
    EXPECT_GT(touch.gap, 0.3) << "of now";
    EXPECT_NEAR(touch.local_a.norm(), 0.01, 1e-6) << "on the ball, where it is by then";
    EXPECT_LT(touch.at_b.triangle, world.object(organ).surface()->topology().triangles().size());
  }
}

TEST(World, CountsWhatItRefuses) {
  CollisionWorld world(margin);
  const auto bodies = heap(10);
  for (const Body& body : bodies) world.place(world.add(CollisionObject(body.outline)), body.pose);
  const auto soft = world.add(CollisionObject(ball_mesh(1), Fidelity::mesh));
  const auto before = world.detect().touches;
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  world.place(3, {Vec3(nan, 0, 0), Quat::Identity()});
  world.place(5, bodies[5].pose, {0, infinity, 0});
  std::vector<Vec3> broken = ball_mesh(1).positions;
  broken[2].y() = nan;
  world.move(soft, broken);
  const auto& after = world.detect();
  EXPECT_EQ(after.rejected, (std::vector<std::uint32_t>{3, 5, soft}));
  ASSERT_EQ(after.touches.size(), before.size());
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_TRUE(same(before[i], after.touches[i]));
  EXPECT_TRUE(world.detect().rejected.empty());
}

TEST(World, MasksSeparate) {
  const auto bodies = heap(40);
  CollisionWorld world(margin);
  for (std::size_t i = 0; i < bodies.size(); ++i)
    world.place(world.add(CollisionObject(bodies[i].outline),
                          {.moves = true, .continuous = false, .mask = {1u << (i % 2), 1u << ((i + 1) % 2)}}),
                bodies[i].pose);
  const auto& touches = world.detect().touches;
  EXPECT_GT(touches.size(), 10u);
  for (const ObjectTouch& touch : touches) EXPECT_NE(touch.a % 2, touch.b % 2);
}

TEST(World, SayWhatMarginIs) {
  EXPECT_THROW(CollisionWorld(0), InputError);
  EXPECT_THROW(CollisionWorld(std::numeric_limits<double>::infinity()), InputError);
}

}  // namespace
}  // namespace prosector
