// Surfaces of triangles.

#include <gtest/gtest.h>

#include <map>
#include <numbers>

#include "common/appearance.h"
#include "server/physics/mechanics/collision/primitives/triangle_crossing.h"
#include "tests/collision/reference/self_contact.h"
#include "tests/collision/shapes.h"

namespace prosector {
namespace {

using namespace test;

std::shared_ptr<const collision::TriangleSurface> surface(const TriangleMesh& mesh) {
  return std::make_shared<collision::TriangleSurface>(mesh);
}

TEST(Topology, KnowsWhatIsClosed) {
  EXPECT_TRUE(surface(ball_mesh(2))->topology().closed());
  EXPECT_TRUE(surface(horseshoe_mesh())->topology().closed());
  EXPECT_TRUE(collision::box_surface(Vec3::Ones())->topology().closed());
  EXPECT_FALSE(surface(sheet_mesh(3, 1))->topology().closed());
  TriangleMesh two = ball_mesh(1);
  const auto n = static_cast<std::uint32_t>(two.positions.size());
  for (const TriangleMesh second = ball_mesh(1); const auto& t : second.triangles)
    two.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  for (std::uint32_t i = 0; i < n; ++i) two.positions.push_back(two.positions[i] + Vec3(5, 0, 0));
  EXPECT_EQ(surface(two)->topology().pieces().size(), 2u);
}

TEST(Surface, NearestPointsAsBruteForceHasThem) {
  Random random(1);
  const TriangleMesh mesh = organ_mesh(3, Vec3::Ones());
  const collision::TriangleSurface s(mesh);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 x = random_point(random, 1);
    double least = 1e9;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      const collision::Triangle c = s.triangle(t);
      least = std::min(least, (collision::at(c, collision::closest_weights(x, c[0], c[1], c[2])) - x).norm());
    }
    const auto found = s.nearest(x);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->distance, least);
    EXPECT_FALSE(s.nearest(x, least * 0.999));
  }
}

TEST(Surface, KnowsInsideFromOutside) {
  Random random(2);
  const collision::TriangleSurface u(horseshoe_mesh());
  const auto inside_u = [](const Vec3& x) {
    const bool in_square = std::abs(x.x()) < 0.5 && std::abs(x.y()) < 0.5 && std::abs(x.z()) < 0.15;
    return in_square && !(std::abs(x.x()) < 0.2 && x.y() > -0.2);
  };
  int inside = 0;
  for (int i = 0; i < 5000; ++i) {
    const Vec3 x = random_point(random, 0.6);
    ASSERT_EQ(u.is_inside(x, *u.nearest(x)), inside_u(x)) << x.transpose();
    inside += inside_u(x);
  }
  EXPECT_GT(inside, 300);
}

TEST(Surface, WindsOnceAroundWhatIsInside) {
  Random random(3);
  const collision::TriangleSurface ball(ball_mesh(3)), u(horseshoe_mesh());
  for (const collision::TriangleSurface* s : {&ball, &u})
    for (int i = 0; i < 500; ++i) {
      const Vec3 x = random_point(random, 1.5);
      EXPECT_NEAR(s->winding_number(x), s->is_inside(x, *s->nearest(x)) ? 1 : 0, 1e-9);
    }
  // A vertex pushed through the ball and out of its other side: beside the tip the nearest face is inside
  // out.
  TriangleMesh dented = ball_mesh(3);
  const Vec3 tip = -1.5 * dented.positions[0];
  const Vec3 beside = tip + 0.02 * dented.positions[0].unitOrthogonal() * tip.norm();
  dented.positions[0] = tip;
  const collision::TriangleSurface folded(dented);
  EXPECT_TRUE(folded.is_inside(beside, *folded.nearest(beside)));
  EXPECT_NEAR(folded.winding_number(beside), 0, 1e-9);
  EXPECT_NEAR(folded.winding_number(0.5 * tip.unitOrthogonal()), 1, 1e-9);
}

/// Returns the solid angle that the surface has from x, in 4 π (Van Oosterom and Strackee 1983).
double solid_angle_share(const collision::TriangleSurface& s, const Vec3& x) {
  double half = 0;
  for (std::uint32_t t = 0; t < s.topology().triangles().size(); ++t) {
    const collision::Triangle corners = s.triangle(t);
    const Vec3 a = corners[0] - x, b = corners[1] - x, c = corners[2] - x;
    half += std::atan2(a.dot(b.cross(c)), a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() +
                                              b.dot(c) * a.norm() + c.dot(a) * b.norm());
  }
  return half / (2 * std::numbers::pi);
}

TEST(Surface, WindsAsItsSolidAngleSaysHoweverItIsCrumpled) {
  Random random(7);
  std::map<int, int> found;
  for (const double crumpled : {0.0, 0.1, 0.5}) {
    TriangleMesh mesh = organ_mesh(3, {1, 2, 3});
    for (Vec3& x : mesh.positions) x += crumpled * random_point(random, 1);
    const collision::TriangleSurface s(mesh);
    for (int i = 0; i < 1000; ++i) {
      const Vec3 middle = (s.box().lo + s.box().hi) / 2;
      const Vec3 x = middle + random_point(random, 1).cwiseProduct(s.box().hi - s.box().lo) / 2;
      const double turns = s.winding_number(x);
      ASSERT_NEAR(turns, solid_angle_share(s, x), 1e-9) << crumpled << ": " << x.transpose();
      ++found[static_cast<int>(std::lround(turns))];
    }
  }
  for (const int turns : {-1, 0, 1, 2}) EXPECT_GT(found[turns], 0) << turns;
  // A ray that meets corners and edges.
  const collision::TriangleSurface ball(ball_mesh(3));
  for (const Vec3& x : ball.positions())
    EXPECT_NEAR(ball.winding_number(Vec3(-0.1, x.y() / 2, x.z() / 2)), 1, 1e-9);
  for (const Vec3& x : ball.positions()) {
    const Vec3 before(x.x() - 3, x.y(), x.z());
    EXPECT_NEAR(ball.winding_number(before), 0, 1e-9);
  }
}

TEST(Surface, FarthestVertexAsBruteForceHasIt) {
  Random random(3);
  const TriangleMesh mesh = organ_mesh(3, {1, 2, 3});
  const collision::TriangleSurface s(mesh);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 d = i < 6 ? Vec3(Vec3::Unit(i % 3) * (i < 3 ? 1 : -1)) : random_unit(random);
    double highest = -1e9;
    for (const Vec3& x : mesh.positions) highest = std::max(highest, d.dot(x));
    EXPECT_NEAR(d.dot(mesh.positions[s.farthest(d)]), highest, 1e-15);
  }
}

void expect_same(const std::optional<collision::Proximity>& a, const std::optional<collision::Proximity>& b,
                 double tolerance) {
  ASSERT_EQ(a.has_value(), b.has_value());
  if (!a) return;
  EXPECT_NEAR(a->gap, b->gap, tolerance);
  EXPECT_LT((a->normal - b->normal).norm(), 1e-6);
}

TEST(Surface, RefittedTreeAnswersAsOneBuiltAnew) {
  Random random(4);
  const TriangleMesh rest = organ_mesh(3, Vec3::Ones());
  const collision::MeshShape other{surface(organ_mesh(2, {0.5, 0.6, 0.4})), {}, 0};
  auto refitted = std::make_shared<collision::TriangleSurface>(rest);
  for (int i = 0; i < 20; ++i) {
    TriangleMesh now = rest;
    const Vec3 wave = random_point(random, 3), bend = random_point(random, 0.5),
               shift = random_point(random, 0.8);
    for (Vec3& x : now.positions) x += bend * std::sin(wave.dot(x)) + shift;
    ASSERT_TRUE(refitted->move(now.positions));
    const auto rebuilt = surface(now);
    expect_same(collision::surface_proximity({refitted, {}, 0}, other, 1),
                collision::surface_proximity({rebuilt, {}, 0}, other, 1), 1e-12);
    for (int k = 0; k < 20; ++k) {
      const Vec3 x = random_point(random, 1);
      EXPECT_EQ(refitted->nearest(x)->distance, rebuilt->nearest(x)->distance);
      EXPECT_EQ(refitted->nearest(x)->triangle, rebuilt->nearest(x)->triangle);
    }
    const auto a = self_contacts(*refitted, 0.05, rest.positions),
               b = self_contacts(*rebuilt, 0.05, rest.positions);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) EXPECT_EQ(a[k].triangle_b, b[k].triangle_b);
  }
}

/// Crossing or near, found by looking at all pairs of triangles.
double brute_force_distance(const collision::MeshShape& a, const collision::MeshShape& b) {
  double least = 1e9;
  const auto placed = [](const collision::MeshShape& s, std::uint32_t t) {
    collision::Triangle c = s.surface->triangle(t);
    for (Vec3& x : c) x = s.pose * x;
    return c;
  };
  for (std::uint32_t i = 0; i < a.surface->topology().triangles().size(); ++i)
    for (std::uint32_t j = 0; j < b.surface->topology().triangles().size(); ++j) {
      const collision::Triangle p = placed(a, i), q = placed(b, j);
      least =
          collision::crossing(p, q).crosses ? 0 : std::min(least, collision::closest(p, q).squared_distance);
      if (least == 0) return 0;
    }
  return std::sqrt(least);
}

TEST(Surfaces, DistanceAsBruteForceHasIt) {
  Random random(5);
  const auto u = surface(horseshoe_mesh()), organ = surface(organ_mesh(1, {0.5, 0.4, 0.3}));
  int apart = 0, crossing_ones = 0;
  for (int i = 0; i < 400; ++i) {
    const collision::MeshShape a{u, random_pose(random, 0.5), 0}, b{organ, random_pose(random, 0.5), 0};
    const double expected = brute_force_distance(a, b);
    const auto found = collision::surface_proximity(a, b, 1e9);
    ASSERT_TRUE(found);
    if (expected == 0) {
      EXPECT_LE(found->gap, 1e-12);
      ++crossing_ones;
    } else if (found->gap > 0) {
      EXPECT_NEAR(found->gap, expected, 1e-12);
      ++apart;
    }
    EXPECT_LT((found->on_a - found->on_b - found->gap * found->normal).norm(), 1e-9);
    EXPECT_NEAR(found->normal.norm(), 1, 1e-12);
  }
  EXPECT_GT(apart, 50);
  EXPECT_GT(crossing_ones, 50);
}

TEST(Surfaces, DepthOfBalls) {
  Random random(6);
  const auto ball = surface(ball_mesh(4));
  for (int i = 0; i < 40; ++i) {
    const Vec3 way = random_unit(random);
    const double depth = between(random, 0.01, 0.5);
    const collision::MeshShape a{ball, {(2 - depth) * way, random_turn(random)}, 0},
        b{ball, {{}, random_turn(random)}, 0};
    const auto found = collision::surface_proximity(a, b, 0);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->gap, -depth, 0.01);  // a chord of the mesh is 0.005 inside
    EXPECT_LT((found->normal - way).norm(), 0.25);
  }
}

TEST(Surfaces, DepthOfBoxesThatOverlapALittle) {
  Random random(7);
  int compared = 0;
  for (int i = 0; i < 2000; ++i) {
    const collision::BoxShape a{random_pose(random, 0.9), {0.5, 0.4, 0.6}},
        b{random_pose(random, 0.9), {0.3, 0.5, 0.7}};
    const auto exact = collision::box_overlap(a, b);
    if (!exact || exact->proximity.gap < -0.05) continue;
    const auto found = collision::surface_proximity({collision::box_surface(a.half), a.pose, 0},
                                                    {collision::box_surface(b.half), b.pose, 0}, 0);
    ASSERT_TRUE(found);
    EXPECT_LE(-found->gap, -exact->proximity.gap + 1e-9) << "pointwise depth is a lower bound";
    ++compared;
  }
  EXPECT_GT(compared, 50);
}

TEST(Surfaces, CrossedRodsHaveDepthThoughNoCornerIsInside) {
  const collision::MeshShape a{collision::box_surface({1, 0.1, 0.1}), {}, 0};
  const Quat turned = Quat(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitY()));
  const collision::MeshShape b{collision::box_surface({1, 0.1, 0.1}), {{0, 0.15, 0}, turned}, 0};
  const auto found = collision::surface_proximity(a, b, 0);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->gap, -0.05, 1e-9);
  EXPECT_LT((found->normal + Vec3::UnitY()).norm(), 1e-9);
}

TEST(Surfaces, OneInsideTheOtherTouches) {
  const collision::MeshShape outer{surface(ball_mesh(3)), {}, 0};
  const collision::MeshShape inner{surface(ball_mesh(2)), {{0.3, 0, 0}, Quat::Identity()}, 0};
  TriangleMesh small = ball_mesh(2);
  for (Vec3& x : small.positions) x *= 0.2;
  const collision::MeshShape seed{surface(small), {{0.3, 0, 0}, Quat::Identity()}, 0};
  const auto found = collision::surface_proximity(outer, seed, 0);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->gap, -0.9, 0.02) << "its far side is 0.9 below the surface";
  EXPECT_LT(collision::surface_proximity(outer, inner, 0)->gap, 0);
}

TEST(Surfaces, SheetsHaveTheirThickness) {
  const auto sheet = surface(sheet_mesh(4, 1));
  const collision::MeshShape lower{sheet, {}, 0.01},
      upper{sheet, {{0.1, 0.05, 0.05}, Quat::Identity()}, 0.02};
  const auto found = collision::surface_proximity(upper, lower, 1);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->gap, 0.02, 1e-12);
  EXPECT_LT((found->normal - Vec3::UnitY()).norm(), 1e-9);
  EXPECT_NEAR(found->on_a.y(), 0.03, 1e-12);
  const Quat up(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitX()));
  const auto crossed = collision::surface_proximity({sheet, {{0, 0.02, 0}, up}, 0.01}, lower, 0);
  ASSERT_TRUE(crossed);
  EXPECT_NEAR(crossed->gap, -0.02, 1e-12);
}

TEST(SelfContact, FindsAFoldAndNoNeighbours) {
  const TriangleMesh rest = sheet_mesh(10, 1);
  TriangleMesh folded = rest;
  for (Vec3& x : folded.positions)
    if (x.x() > 1e-9) x = Vec3(-x.x() + 0.02, 0.03, x.z());
  const collision::TriangleSurface flat(rest), now(folded);
  EXPECT_TRUE(self_contacts(flat, 0.04).empty());
  const auto found = self_contacts(now, 0.04, rest.positions);
  EXPECT_GT(found.size(), 100u);
  for (const SelfContact& c : found) {
    EXPECT_LT(c.triangle_a, c.triangle_b);
    EXPECT_LT(c.distance, 0.04);
    EXPECT_NEAR((c.on_a - c.on_b).norm(), c.distance, 1e-12);
    EXPECT_GE(collision::closest(flat.triangle(c.triangle_a), flat.triangle(c.triangle_b)).squared_distance,
              0.04 * 0.04);
  }
  // As brute force has them.
  std::size_t expected = 0;
  for (std::uint32_t s = 0; s < rest.triangles.size(); ++s)
    for (std::uint32_t t = s + 1; t < rest.triangles.size(); ++t) {
      const bool near = collision::crossing(now.triangle(s), now.triangle(t)).count > 0 ||
                        collision::closest(now.triangle(s), now.triangle(t)).squared_distance < 0.04 * 0.04;
      expected +=
          near && collision::closest(flat.triangle(s), flat.triangle(t)).squared_distance >= 0.04 * 0.04;
    }
  EXPECT_EQ(found.size(), expected);
}

}  // namespace
}  // namespace prosector
