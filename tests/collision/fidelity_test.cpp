// All fidelities against each other, over shapes and poses.

#include <gtest/gtest.h>

#include "common/error.h"
#include "tests/collision/reference/narrow_phase.h"
#include "tests/collision/shapes.h"

namespace prosector {
namespace {

using namespace test;

constexpr std::array all = {Fidelity::sphere, Fidelity::aabb, Fidelity::obb, Fidelity::hull, Fidelity::mesh};

TEST(Fidelity, HasNames) {
  for (const auto& [fidelity, name] :
       {std::pair{Fidelity::none, "none"}, std::pair{Fidelity::sphere, "sphere"},
        std::pair{Fidelity::aabb, "aabb"}, std::pair{Fidelity::obb, "obb"}, std::pair{Fidelity::hull, "hull"},
        std::pair{Fidelity::mesh, "mesh"}})
    EXPECT_EQ(fidelity_name(fidelity), name);
}

class Shapes : public testing::TestWithParam<std::size_t> {
 protected:
  std::size_t shape_ = GetParam();
  std::size_t other_ = (GetParam() + 3) % shape_table().size();
};
INSTANTIATE_TEST_SUITE_P(All, Shapes, testing::Range<std::size_t>(0, 7),
                         [](const auto& row) { return shape_table()[row.param].name; });

// What encloses can't miss: where the meshes touch, so does every coarser shape, and as deep at least.
TEST_P(Shapes, NoCoarserFidelityMissesWhatMeshHits) {
  Random random(1);
  int hits = 0;
  for (int i = 0; i < 40; ++i) {
    const Pose a = random_pose(random, 0.06), b = random_pose(random, 0.06);
    const auto truth =
        proximity(from_table(shape_, Fidelity::mesh, a), from_table(other_, Fidelity::mesh, b), 0);
    if (!truth || truth->gap > 0) continue;
    ++hits;
    for (const Fidelity fa : all)
      for (const Fidelity fb : all) {
        if (fa == Fidelity::mesh && fb == Fidelity::mesh) continue;
        const auto found = proximity(from_table(shape_, fa, a), from_table(other_, fb, b), 0.01);
        ASSERT_TRUE(found) << fidelity_name(fa) << " " << fidelity_name(fb);
        EXPECT_LE(found->gap, 1e-12) << fidelity_name(fa) << " " << fidelity_name(fb);
      }
  }
  EXPECT_GT(hits, 3);
}

TEST_P(Shapes, EverySoftFidelityEnclosesItsMesh) {
  Random random(2);
  for (int i = 0; i < 40; ++i) {
    TriangleMesh mesh = organ_mesh(2, {0.1, 0.08, 0.06});
    const Vec3 wave = random_point(random, 40), bend = random_point(random, 0.02);
    for (Vec3& x : mesh.positions) x += bend * std::sin(wave.dot(x));
    const CollisionObject probe = from_table(shape_, Fidelity::mesh, random_pose(random, 0.08));
    const auto truth = proximity(CollisionObject(mesh, Fidelity::mesh), probe, 0);
    for (const Fidelity fidelity : all) {
      const auto found = proximity(CollisionObject(mesh, fidelity), probe, 0.01);
      if (truth) {
        ASSERT_TRUE(found && found->gap <= 1e-12) << fidelity_name(fidelity);
      }
    }
  }
}

TEST_P(Shapes, SwappingChangesNothingButTheSide) {
  Random random(3);
  for (int i = 0; i < 12; ++i) {
    const Pose a = random_pose(random, 0.07), b = random_pose(random, 0.07);
    for (const Fidelity fa : all)
      for (const Fidelity fb : all) {
        const CollisionObject p = from_table(shape_, fa, a), q = from_table(other_, fb, b);
        const auto one = proximity(p, q, 0.02), two = proximity(q, p, 0.02);
        ASSERT_EQ(one.has_value(), two.has_value());
        if (!one) continue;
        EXPECT_NEAR(one->gap, two->gap, 2e-6) << fidelity_name(fa) << " " << fidelity_name(fb);
      }
  }
}

TEST_P(Shapes, MovingBothTogetherChangesNothing) {
  Random random(4);
  for (int i = 0; i < 12; ++i) {
    const Pose a = random_pose(random, 0.07), b = random_pose(random, 0.07),
               together = random_pose(random, 2);
    for (const Fidelity fidelity : {Fidelity::sphere, Fidelity::obb, Fidelity::hull, Fidelity::mesh}) {
      const auto before = proximity(from_table(shape_, fidelity, a), from_table(other_, fidelity, b), 0.02);
      const auto after = proximity(from_table(shape_, fidelity, together * a),
                                   from_table(other_, fidelity, together * b), 0.02);
      ASSERT_EQ(before.has_value(), after.has_value()) << fidelity_name(fidelity);
      if (!before) continue;
      EXPECT_NEAR(before->gap, after->gap, 2e-6) << fidelity_name(fidelity);
    }
  }
}

TEST_P(Shapes, ResultsFitTogether) {
  Random random(5);
  for (int i = 0; i < 12; ++i) {
    const Pose a = random_pose(random, 0.07), b = random_pose(random, 0.07);
    for (const Fidelity fa : all)
      for (const Fidelity fb : all) {
        const auto found = proximity(from_table(shape_, fa, a), from_table(other_, fb, b), 0.02);
        if (!found) continue;
        EXPECT_NEAR(found->normal.norm(), 1, 1e-12);
        EXPECT_LT((found->on_a - found->on_b - found->gap * found->normal).norm(), 1e-9)
            << fidelity_name(fa) << " " << fidelity_name(fb);
        EXPECT_LE(found->gap, 0.02);
      }
  }
}

TEST(Fidelity, NoneTouchesNothing) {
  const auto parts = shape_table().front().parts;
  EXPECT_FALSE(proximity(rigid(parts, Fidelity::none), rigid(parts, Fidelity::mesh), 1));
  EXPECT_FALSE(proximity(CollisionObject(ball_mesh(1), Fidelity::none), rigid(parts, Fidelity::mesh), 1));
}

// Balls: the closed form at every fidelity that can be exact.
TEST(Fidelity, BallsAsClosedForm) {
  Random random(6);
  const std::vector<collision::ShapePart> ball{
      {collision::ShapeKind::sphere, Vec3::Constant(0.05), {}, nullptr}};
  for (int i = 0; i < 200; ++i) {
    const Pose a = random_pose(random, 0.06), b = random_pose(random, 0.06);
    const double expected = (a.p - b.p).norm() - 0.1;
    for (const Fidelity fa : {Fidelity::sphere, Fidelity::hull})
      for (const Fidelity fb : {Fidelity::sphere, Fidelity::hull})
        EXPECT_NEAR(proximity(rigid(ball, fa, a), rigid(ball, fb, b), 1)->gap, expected, 1e-12);
    EXPECT_NEAR(proximity(rigid(ball, Fidelity::hull, a), rigid(ball, Fidelity::mesh, b), 1)->gap, expected,
                6e-4);
  }
}

TEST(Fidelity, SoftTouchNamesItsMaterialPoint) {
  const TriangleMesh mesh = organ_mesh(2, {0.1, 0.08, 0.06});
  const CollisionObject soft(mesh, Fidelity::mesh);
  const std::vector<collision::ShapePart> ball{
      {collision::ShapeKind::sphere, Vec3::Constant(0.02), {}, nullptr}};
  const auto found = proximity(rigid(ball, Fidelity::sphere, {{0, 0.06, 0}, Quat::Identity()}), soft, 0.02);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->at_a.triangle, collision::SurfacePoint::none);
  ASSERT_LT(found->at_b.triangle, mesh.triangles.size());
  EXPECT_LT((collision::at(soft.surface()->triangle(found->at_b.triangle), found->at_b.weights) - found->on_b)
                .norm(),
            1e-12);
}

TEST(Fidelity, FingersBend) {
  const auto hand = shape_table().back().parts;
  for (const Fidelity fidelity : all) {
    CollisionObject object = rigid(hand, fidelity);
    ASSERT_TRUE(object.bend(12, {{0.03, 0.2, 0}, Quat::Identity()}));
    ASSERT_TRUE(object.place({}));
    EXPECT_GE(object.box().hi.y(), 0.2 + 0.018 - 1e-9) << fidelity_name(fidelity);
    EXPECT_LT(object.box().hi.y(), 0.4);
  }
}

TEST(Fidelity, SurfaceIsCut) {
  const std::vector<collision::ShapePart> ball{
      {collision::ShapeKind::sphere, Vec3::Constant(0.2), {}, nullptr}};
  const CollisionObject probe = rigid(ball, Fidelity::hull, {{1.1, 0, 0}, Quat::Identity()});
  TriangleMesh whole = ball_mesh(2), half = whole;
  std::erase_if(half.triangles, [&](const auto& t) {
    return half.positions[t[0]].x() + half.positions[t[1]].x() + half.positions[t[2]].x() > 0;
  });
  CollisionObject soft(whole, Fidelity::mesh);
  EXPECT_TRUE(proximity(soft, probe, 0));
  soft.cut(half);
  EXPECT_FALSE(proximity(soft, probe, 0));
  EXPECT_TRUE(soft.move(half.positions));
}

}  // namespace
}  // namespace prosector
