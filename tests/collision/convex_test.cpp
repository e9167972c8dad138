// Convex shapes: what Bullet's single precision is worth behind our planes.

#include "server/physics/mechanics/collision/narrow/convex_contact.h"

#include <gtest/gtest.h>

#include "tests/collision/shapes.h"

namespace prosector {
namespace {

using namespace test;

constexpr double far_away = 1e9;

Vec3 highest(const std::vector<Vec3>& points, const Vec3& direction) {
  return *std::max_element(points.begin(), points.end(),
                           [&](const Vec3& a, const Vec3& b) { return a.dot(direction) < b.dot(direction); });
}

std::vector<Vec3> placed(const std::vector<Vec3>& points, const Pose& pose) {
  std::vector<Vec3> out;
  for (const Vec3& x : points) out.push_back(pose * x);
  return out;
}

TEST(Hull, IsThatOfAllItsPoints) {
  Random random(1);
  for (int i = 0; i < 50; ++i) {
    std::vector<Vec3> cloud = random_cloud(random, 12);
    for (int k = 0; k < 200; ++k) {  // nearly on the surface: some stick out, some don't
      const auto pick = [&] { return cloud[std::uniform_int_distribution<std::size_t>(0, 11)(random)]; };
      const Vec3 a = pick(), b = pick();
      cloud.push_back((a + b) / 2 * (1 + between(random, -1e-5, 1e-5)));
    }
    const collision::PointHull hull(cloud);
    for (int k = 0; k < 500; ++k) {
      const Vec3 d = random_unit(random);
      ASSERT_EQ(d.dot(hull.farthest(d)), d.dot(highest(cloud, d)));
    }
  }
}

TEST(Hull, OfFewPointsWorks) {
  for (const std::vector<Vec3>& points : {std::vector<Vec3>{Vec3(1, 2, 3)},
                                          {Vec3(0, 0, 0), Vec3(1, 0, 0)},
                                          {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}}) {
    const collision::PointHull hull(points);
    EXPECT_FALSE(hull.faces()->topology().triangles().empty());
    for (const Vec3& x : points)
      EXPECT_EQ((hull.farthest(x - hull.center() + Vec3(1e-9, 0, 0)) - x).norm() < 2, true);
    const auto found =
        collision::convex_proximity(hull, {}, collision::ConvexBall(Vec3(0, 0, 10), 1), {}, far_away);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->normal.norm(), 1, 1e-12);
  }
}

TEST(Convex, BallsAsClosedForm) {
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const collision::ConvexBall a(random_point(random), between(random, 0.01, 1)),
        b(random_point(random), between(random, 0.01, 1));
    const auto found = collision::convex_proximity(a, {}, b, {}, far_away);
    ASSERT_TRUE(found);
    const Vec3 way = a.center() - b.center();
    EXPECT_NEAR(found->gap, way.norm() - a.rounding() - b.rounding(), 1e-12);
    EXPECT_LT((found->normal - way.normalized()).norm(), 1e-6);
  }
}

TEST(Convex, DistanceHasPlanesBetween) {
  Random random(3);
  double worst = 0, worst_normal = 0;
  int apart = 0;
  for (int i = 0; i < 250; ++i) {
    const std::vector<Vec3> a = random_cloud(random, 20), b = random_cloud(random, 20);
    const Pose pa = random_pose(random, 1.5), pb = random_pose(random, 1.5);
    const collision::PointHull hull_a(a), hull_b(b);
    const auto found = collision::convex_proximity(hull_a, pa, hull_b, pb, far_away);
    ASSERT_TRUE(found);
    if (found->gap < 1e-3) continue;
    ++apart;
    // The gap of two planes is never more than the distance, the way between two points never less.
    EXPECT_NEAR((found->on_a - found->on_b).dot(found->normal), found->gap, 1e-12);
    const auto in_room_a = placed(a, pa), in_room_b = placed(b, pb);
    const double planes =
        found->normal.dot(highest(in_room_a, -found->normal) - highest(in_room_b, found->normal));
    EXPECT_NEAR(planes, found->gap, 1e-12);
    // The exact distance: from triangles of the hulls' faces.
    const auto exact =
        collision::surface_proximity({hull_a.faces(), pa, 0}, {hull_b.faces(), pb, 0}, far_away);
    ASSERT_TRUE(exact);
    worst = std::max(worst, std::abs(exact->gap - found->gap));
    worst_normal = std::max(worst_normal, (exact->normal - found->normal).norm());
  }
  EXPECT_GT(apart, 150);
  EXPECT_LT(worst, 1e-12);
  EXPECT_LT(worst_normal, 1e-9);
}

TEST(Convex, DepthAsAllPlanesHaveIt) {
  Random random(4);
  double worst = 0;
  int overlapping = 0;
  for (int i = 0; i < 600; ++i) {
    const std::vector<Vec3> a = random_cloud(random, 8), b = random_cloud(random, 8);
    const Pose pa = random_pose(random, 0.3), pb = random_pose(random, 0.3);
    const double depth = brute_force_depth(placed(a, pa), placed(b, pb));
    const auto found =
        collision::convex_proximity(collision::PointHull(a), pa, collision::PointHull(b), pb, far_away);
    ASSERT_TRUE(found);
    if (depth < 0) {
      EXPECT_GT(found->gap, 0);
      continue;
    }
    ++overlapping;
    ASSERT_LE(found->gap, -depth + 1e-12) << "planes can't be nearer than the least overlap";
    worst = std::max(worst, -found->gap - depth);
  }
  EXPECT_GT(overlapping, 150);
  EXPECT_LT(worst, 1e-6) << "Bullet's EPA is in single precision";
}

TEST(Convex, RoundOnesAsClosedForm) {
  // An ellipsoid's pole over a box; a capsule beside another; a cylinder's rim on a ball.
  const collision::ShapePart ellipsoid{collision::ShapeKind::ellipsoid, {0.3, 0.2, 0.1}, {}, nullptr};
  const auto over =
      collision::convex_proximity(*collision::make_convex(ellipsoid), {{0, 0.75, 0}, Quat::Identity()},
                                  collision::ConvexBox({1, 0.5, 1}), {}, far_away);
  ASSERT_TRUE(over);
  EXPECT_NEAR(over->gap, 0.05, 1e-6);
  EXPECT_LT((over->normal - Vec3::UnitY()).norm(), 1e-3);
  const collision::ShapePart capsule{collision::ShapeKind::capsule, {0.1, 0.5, 0.1}, {}, nullptr};
  const Quat across(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitX()));
  const auto crossed = collision::convex_proximity(*collision::make_convex(capsule), {{0.15, 0, 0}, across},
                                                   *collision::make_convex(capsule), {}, far_away);
  ASSERT_TRUE(crossed);
  EXPECT_NEAR(crossed->gap, -0.05, 1e-9);
  EXPECT_LT((crossed->normal - Vec3::UnitX()).norm(), 1e-6);
  const collision::ShapePart cylinder{collision::ShapeKind::cylinder, {0.3, 0.4, 0.3}, {}, nullptr};
  const auto rim = collision::convex_proximity(*collision::make_convex(cylinder), {},
                                               collision::ConvexBall({0.6, 0.8, 0}, 0.1), {}, far_away);
  ASSERT_TRUE(rim);
  EXPECT_NEAR(rim->gap, 0.4, 1e-6);
}

// Round shapes have no plane that a polytope finds exactly. The reference looks at very many planes.
TEST(Convex, DepthOfRoundOnes) {
  Random random(6);
  const auto ellipsoid = [&] {
    const Vec3 half = Vec3::Constant(0.02) + 0.03 * random_point(random).cwiseAbs();
    return collision::make_convex({collision::ShapeKind::ellipsoid, half, {}, nullptr});
  };
  const auto planes = [](const collision::Convex& a, const Pose& pa, const collision::Convex& b,
                         const Pose& pb, const Vec3& n) {
    return n.dot(pa * a.farthest(pa.q.conjugate() * -n) - pb * b.farthest(pb.q.conjugate() * n));
  };
  int overlapping = 0;
  for (int i = 0; i < 300; ++i) {
    const auto a = ellipsoid(), b = ellipsoid();
    const Pose pa = random_pose(random, 0.03), pb = random_pose(random, 0.03);
    const auto found = collision::convex_proximity(*a, pa, *b, pb, 0);
    if (!found) continue;
    ++overlapping;
    double gap = -1;
    Vec3 best = Vec3::UnitX();
    for (int k = 0; k < 2000; ++k) {
      const Vec3 n = k < 800 ? random_unit(random)
                             : Vec3((best + 0.3 * std::pow(0.995, k) * random_unit(random)).normalized());
      if (const double g = planes(*a, pa, *b, pb, n); g > gap) {
        gap = g;
        best = n;
      }
    }
    EXPECT_LE(gap - found->gap, 1e-6) << i << " " << found->gap;
  }
  EXPECT_GT(overlapping, 100);
}

TEST(Boxes, DepthAsAllPlanesHaveItAndEpaAgrees) {
  Random random(5);
  int overlapping = 0, shallow = 0;
  double worst = 0;
  for (int i = 0; i < 3000; ++i) {
    const collision::BoxShape a{random_pose(random, 0.9),
                                random_point(random).cwiseAbs() + Vec3::Constant(0.05)};
    const collision::BoxShape b{random_pose(random, 0.9),
                                random_point(random).cwiseAbs() + Vec3::Constant(0.05)};
    const auto corners = [](const collision::BoxShape& box) {
      std::vector<Vec3> out;
      const auto surface = collision::box_surface(box.half);
      for (const Vec3& x : surface->positions()) out.push_back(box.pose * x);
      return out;
    };
    const double depth = brute_force_depth(corners(a), corners(b));
    const auto found = collision::box_overlap(a, b);
    ASSERT_EQ(found.has_value(), depth >= 0);
    if (!found) continue;
    ++overlapping;
    EXPECT_NEAR(-found->proximity.gap, depth, 1e-8);
    ASSERT_GE(found->count, 1u);
    const auto epa = collision::convex_proximity(collision::ConvexBox(a.half), a.pose,
                                                 collision::ConvexBox(b.half), b.pose, 0);
    ASSERT_TRUE(epa);
    worst = std::max(worst, std::abs(epa->gap - found->proximity.gap));
    // What touches lies in or on both, unless one is nearly through the other.
    if (depth > 0.3 * std::min(a.half.minCoeff(), b.half.minCoeff())) continue;
    ++shallow;
    for (std::size_t k = 0; k < found->count; ++k)
      for (const collision::BoxShape& box : {a, b}) {
        const Vec3 local = box.pose.inverse() * found->patch[k];
        EXPECT_TRUE(((local.cwiseAbs() - box.half).array() < 1e-7).all());
      }
  }
  EXPECT_GT(overlapping, 500);
  EXPECT_GT(shallow, 100);
  EXPECT_LT(worst, 1e-5);
}

TEST(Boxes, RestOnTheirPatch) {
  const collision::BoxShape table{{}, {1, 0.1, 1}},
      block{{{0.9, 0.19, 0}, Quat::Identity()}, {0.2, 0.1, 0.2}};
  const auto found = collision::box_overlap(block, table);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->proximity.gap, -0.01, 1e-12);
  EXPECT_LT((found->proximity.normal - Vec3::UnitY()).norm(), 1e-12);
  EXPECT_EQ(found->count, 4u);
  EXPECT_LT((found->proximity.point() - Vec3(0.85, 0.095, 0)).norm(), 1e-12) << "the part over the table";
}

TEST(Spheres, AgainstBoxes) {
  const collision::BoxShape box{{}, {1, 2, 3}};
  const auto outside = collision::sphere_box_proximity({{2, 3, 0}, 0.1}, box, 10);
  ASSERT_TRUE(outside);
  EXPECT_NEAR(outside->gap, std::sqrt(2.0) - 0.1, 1e-12);
  const auto inside = collision::sphere_box_proximity({{0.8, 0, 0}, 0.1}, box, 0);
  ASSERT_TRUE(inside);
  EXPECT_NEAR(inside->gap, -0.3, 1e-12);
  EXPECT_LT((inside->normal - Vec3::UnitX()).norm(), 1e-12);
}

}  // namespace
}  // namespace prosector
