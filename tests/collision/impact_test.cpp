// When moving things meet.

#include <gtest/gtest.h>

#include <numbers>

#include "tests/collision/reference/narrow_phase.h"
#include "tests/collision/shapes.h"

namespace prosector {
namespace {

using namespace test;

constexpr double slop = 1e-6;
constexpr std::array all_fidelities = {Fidelity::sphere, Fidelity::aabb, Fidelity::obb, Fidelity::hull,
                                       Fidelity::mesh};

TEST(Impact, OfBallsAsClosedForm) {
  Random random(1);
  const std::vector<collision::ShapePart> ball{
      {collision::ShapeKind::sphere, Vec3::Constant(0.1), {}, nullptr}};
  int met = 0;
  for (int i = 0; i < 500; ++i) {
    CollisionObject a = rigid(ball, Fidelity::sphere), b = rigid(ball, Fidelity::hull);
    const Vec3 pa = random_point(random), pb = random_point(random),
               va = 2 * (pb - pa) + random_point(random, 0.4), vb = random_point(random, 0.4);
    a.place({pa, Quat::Identity()}, va, random_point(random, 20));
    b.place({pb, Quat::Identity()}, vb);
    // |p + t v| = 0.2
    const Vec3 p = pa - pb, v = va - vb;
    const double half_b = p.dot(v), c = p.squaredNorm() - 0.04, root = half_b * half_b - v.squaredNorm() * c;
    const double expected = c <= 0 ? 0 : root < 0 || half_b > 0 ? 1e9 : c / (-half_b + std::sqrt(root));
    const auto found = time_of_impact(a, b, 1, slop);
    if (std::abs(root) < 1e-3 || std::abs(expected - 1) < 1e-3) continue;
    ASSERT_EQ(found.has_value(), expected < 1) << expected;
    if (!found) continue;
    EXPECT_TRUE(found->converged);
    EXPECT_LE(found->time, expected + 1e-12) << "never later";
    EXPECT_NEAR(found->time, expected, 1e-4);
    ++met;
  }
  EXPECT_GT(met, 30);
}

TEST(Impact, OfABoxThatFallsOnATableAtEveryFidelity) {
  const std::vector<collision::ShapePart> table{{collision::ShapeKind::box, {1, 0.1, 1}, {}, nullptr}},
      box{{collision::ShapeKind::box, {0.1, 0.1, 0.1}, {}, nullptr}};
  for (const Fidelity fa : {Fidelity::aabb, Fidelity::obb, Fidelity::hull, Fidelity::mesh})
    for (const Fidelity fb : {Fidelity::aabb, Fidelity::obb, Fidelity::hull, Fidelity::mesh}) {
      CollisionObject a = rigid(box, fa);
      a.place({{0, 0.7, 0}, Quat::Identity()}, {0.3, -50, 0});
      const auto found = time_of_impact(a, rigid(table, fb), 1. / 60, slop);
      ASSERT_TRUE(found) << fidelity_name(fa) << " " << fidelity_name(fb);
      EXPECT_NEAR(found->time, 0.01, 1e-6);
      EXPECT_LE(found->time, 0.01);
      EXPECT_LT((found->at.normal - Vec3::UnitY()).norm(), 1e-6);
    }
}

TEST(Impact, OfATurningRod) {
  // A rod of half length 1 about its middle, at 2 rad/s; its end comes down on a ball beside it.
  const std::vector<collision::ShapePart> rod{{collision::ShapeKind::capsule, {0.01, 1, 0.01}, {}, nullptr}},
      ball{{collision::ShapeKind::sphere, Vec3::Constant(0.1), {}, nullptr}};
  const double angle = 0.8;
  CollisionObject turning = rigid(rod, Fidelity::hull);
  turning.place({}, Vec3::Zero(), {0, 0, 2});
  const CollisionObject still =
      rigid(ball, Fidelity::hull, {0.9 * Vec3(-std::sin(angle), std::cos(angle), 0), Quat::Identity()});
  const double expected = (angle - std::asin(0.11 / 0.9)) / 2;
  const auto found = time_of_impact(turning, still, 1, slop);
  ASSERT_TRUE(found && found->converged);
  EXPECT_NEAR(found->time, expected, 1e-5);
  EXPECT_LE(found->time, expected);
  EXPECT_FALSE(time_of_impact(turning, still, expected / 2, slop));
}

TEST(Impact, NeverPassesThroughAThinSheet) {
  // A probe at 50 m/s goes through a sheet within a tick; where it is before and after touches nothing.
  const std::vector<collision::ShapePart> ball{
      {collision::ShapeKind::sphere, Vec3::Constant(0.005), {}, nullptr}};
  const TriangleMesh mesh = sheet_mesh(8, 0.3);
  const CollisionObject sheet(mesh, Fidelity::mesh, 0.001);
  Random random(2);
  for (int i = 0; i < 40; ++i) {
    CollisionObject probe = rigid(ball, Fidelity::hull);
    const Vec3 start(between(random, -0.1, 0.1), 0.4, between(random, -0.1, 0.1));
    probe.place({start, Quat::Identity()}, {0, -50, 0});
    EXPECT_FALSE(proximity(probe, sheet, 0));
    const auto found = time_of_impact(probe, sheet, 1. / 60, slop);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->time, (0.4 - 0.0055) / 50, 1e-7);
  }
}

TEST(Impact, OfASoftSurfaceThatMovesInParts) {
  // A ball that grows: each vertex goes its own way.
  const TriangleMesh ball = ball_mesh(2);
  std::vector<Vec3> outward = ball.positions;
  for (Vec3& v : outward) v *= 3;
  const std::vector<collision::ShapePart> wall{{collision::ShapeKind::box, {0.1, 4, 4}, {}, nullptr}};
  for (const Fidelity fidelity : all_fidelities) {
    CollisionObject soft(ball, fidelity);
    ASSERT_TRUE(soft.move(ball.positions, outward));
    const auto found =
        time_of_impact(soft, rigid(wall, Fidelity::hull, {{2.6, 0, 0}, Quat::Identity()}), 1, slop);
    ASSERT_TRUE(found && found->converged) << fidelity_name(fidelity);
    EXPECT_LE(found->time, 0.5) << fidelity_name(fidelity);
    EXPECT_NEAR(found->time, 0.5, 1e-5) << fidelity_name(fidelity);
  }
}

TEST(Impact, SoftOnSoft) {
  const TriangleMesh ball = ball_mesh(2);
  CollisionObject a(ball, Fidelity::mesh), b(moved(ball, {{3, 0, 0}, Quat::Identity()}), Fidelity::mesh);
  std::vector<Vec3> right(ball.positions.size(), Vec3(2, 0, 0)), left(ball.positions.size(), Vec3(-2, 0, 0));
  ASSERT_TRUE(a.move(ball.positions, right));
  const auto at = moved(ball, {{3, 0, 0}, Quat::Identity()}).positions;
  ASSERT_TRUE(b.move(at, left));
  const auto found = time_of_impact(a, b, 1, slop);
  ASSERT_TRUE(found && found->converged);
  EXPECT_NEAR(found->time, 0.25, 1e-6);
}

// Whatever the shapes: before the impact they don't touch, at the impact they nearly do.
TEST(Impact, ComesWithTheGapAndNotBefore) {
  Random random(3);
  int met = 0;
  for (int i = 0; i < 42; ++i) {
    const auto p = static_cast<std::size_t>(i) % 7, q = static_cast<std::size_t>(i / 7) % 7;
    for (const Fidelity fidelity : all_fidelities) {
      CollisionObject a = from_table(p, fidelity), b = from_table(q, fidelity);
      const Vec3 away = 0.3 * random_unit(random);
      a.place({away, random_turn(random)}, -20 * away + random_point(random, 0.5), random_point(random, 10));
      b.place({Vec3::Zero(), random_turn(random)}, Vec3::Zero(), random_point(random, 10));
      const auto found = time_of_impact(a, b, 0.05, 1e-5);
      if (!found) continue;
      ++met;
      EXPECT_GE(found->time, 0);
      EXPECT_LE(found->time, 0.05);
      EXPECT_TRUE(!found->converged || found->at.gap <= 1e-5);
      for (const double share : {0.3, 0.7, 0.95})
        for (const auto& x : a.pieces_after(share * found->time))
          for (const auto& y : b.pieces_after(share * found->time)) {
            const auto early = collision::proximity(x, y, 0);
            EXPECT_FALSE(early && early->gap < -1e-9 && found->time > 0);
          }
    }
  }
  EXPECT_GT(met, 100);
}

}  // namespace
}  // namespace prosector
