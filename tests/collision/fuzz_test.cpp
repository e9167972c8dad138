// Odd input: a clear error, or an answer; never a crash, never not a number.

#include <gtest/gtest.h>

#include <limits>

#include "common/error.h"
#include "server/physics/mechanics/collision/narrow/convex_contact.h"
#include "tests/collision/reference/narrow_phase.h"
#include "tests/collision/reference/self_contact.h"
#include "tests/collision/shapes.h"

namespace prosector {
namespace {

using namespace test;

constexpr std::array all_and_none = {Fidelity::none, Fidelity::sphere, Fidelity::aabb,
                                     Fidelity::obb,  Fidelity::hull,   Fidelity::mesh};

/// A number of the kind that breaks things.
double odd_number(Random& random) {
  switch (std::uniform_int_distribution<int>(0, 9)(random)) {
    case 0:
      return 0;
    case 1:
      return 1e-300;
    case 2:
      return 1e8;
    case 3:
      return -1e8;
    case 4:
      return 1e-9;
    case 5:
      return 1;
    default:
      return between(random, -1, 1);
  }
}

Vec3 odd_point(Random& random) {
  const double x = odd_number(random), y = odd_number(random);
  return {x, y, odd_number(random)};
}

TEST(Fuzz, SurfacesOfOddTriangles) {
  Random random(1);
  std::uniform_int_distribution<std::uint32_t> vertex(0, 7);
  int made = 0;
  for (int i = 0; i < 1000; ++i) {
    TriangleMesh mesh;
    for (int k = 0; k < 8; ++k)
      mesh.positions.push_back(k % 3 && i % 2 ? mesh.positions[0] : odd_point(random));
    for (int k = 0; k < 10; ++k) {
      const std::uint32_t a = vertex(random), b = vertex(random), c = vertex(random);
      if (a != b && b != c && c != a) mesh.triangles.push_back({a, b, c});
    }
    if (mesh.triangles.empty()) continue;
    ++made;
    const Fidelity fa = all_and_none[static_cast<std::size_t>(i) % all_and_none.size()],
                   fb = all_and_none[static_cast<std::size_t>(i / 6) % all_and_none.size()];
    CollisionObject a(mesh, fa, i % 3 ? 0 : 0.01);
    const CollisionObject b =
        from_table(static_cast<std::size_t>(i) % 7, fb, {odd_point(random), random_turn(random)});
    if (const auto found = proximity(a, b, 0.1)) {
      EXPECT_TRUE(std::isfinite(found->gap) && found->normal.allFinite() && found->on_a.allFinite());
      EXPECT_NEAR(found->normal.norm(), 1, 1e-9);
    }
    self_contacts(*a.surface(), 0.01);
    std::vector<Vec3> velocities(8, odd_point(random));
    velocities[3] = odd_point(random);
    a.move(mesh.positions, velocities);
    if (i % 10) continue;
    const auto met = time_of_impact(a, b, 0.01, 1e-5);
    EXPECT_TRUE(!met || (met->time >= 0 && met->time <= 0.01));
  }
  EXPECT_GT(made, 950);
}

TEST(Fuzz, HullsOfOddClouds) {
  Random random(2);
  for (int i = 0; i < 2000; ++i) {
    std::vector<Vec3> cloud;
    const int kind = i % 5;
    for (int k = 0; k < 1 + i % 9; ++k) {
      Vec3 x = random_point(random);
      if (kind == 1) x.z() = 0;              // in a plane
      if (kind == 2) x = Vec3(x.x(), 0, 0);  // on a line
      if (kind == 3) x = Vec3::Ones();       // one point
      if (kind == 4) x *= 1e-12;             // tiny
      cloud.push_back(x);
    }
    const collision::PointHull a(cloud), b(random_cloud(random, 8));
    const Pose pose = random_pose(random);
    const auto found = collision::convex_proximity(a, {}, b, pose, 1e9);
    ASSERT_TRUE(found);
    EXPECT_TRUE(std::isfinite(found->gap) && found->on_a.allFinite());
    EXPECT_NEAR(found->normal.norm(), 1, 1e-9);
  }
}

TEST(Fuzz, ObjectsInOnePlace) {
  for (std::size_t shape = 0; shape < shape_table().size(); ++shape)
    for (const Fidelity fa : all_and_none)
      for (const Fidelity fb : all_and_none) {
        const CollisionObject a = from_table(shape, fa), b = from_table(shape, fb);
        const auto found = proximity(a, b, 0);
        if (fa == Fidelity::none || fb == Fidelity::none) {
          EXPECT_FALSE(found);
          continue;
        }
        ASSERT_TRUE(found) << shape_table()[shape].name << fidelity_name(fa) << fidelity_name(fb);
        EXPECT_TRUE(found->gap <= 0 && found->normal.allFinite());
        EXPECT_NEAR(found->normal.norm(), 1, 1e-9);
      }
}

TEST(Fuzz, BadInputIsSaidClearly) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refuses = [](const std::vector<collision::ShapePart>& parts) {
    for (const Fidelity fidelity : all_and_none)
      EXPECT_THROW(collision::RigidOutline(parts, fidelity), InputError);
  };
  refuses({});
  refuses({{collision::ShapeKind::box, {1, 0, 1}, {}, nullptr}});
  refuses({{collision::ShapeKind::sphere, {-1, 0, 0}, {}, nullptr}});
  refuses({{collision::ShapeKind::ellipsoid, {1, nan, 1}, {}, nullptr}});
  refuses({{collision::ShapeKind::box, {1, 1, 1}, {Vec3(nan, 0, 0), Quat::Identity()}, nullptr}});
  refuses({{collision::ShapeKind::triangles, {1, 1, 1}, {}, nullptr}});
  refuses({{collision::ShapeKind::hull, {1, 1, 1}, {}, std::make_shared<TriangleMesh>()}});
  TriangleMesh mesh = ball_mesh(0);
  mesh.triangles.push_back({0, 1, 77});
  EXPECT_THROW(collision::TriangleSurface{mesh}, InputError);
  mesh.triangles.back() = {0, 1, 1};
  EXPECT_THROW(collision::TriangleSurface{mesh}, InputError);
  mesh.triangles.pop_back();
  mesh.positions[0].x() = nan;
  EXPECT_THROW(collision::TriangleSurface{mesh}, InputError);
  EXPECT_THROW(collision::TriangleSurface{TriangleMesh{}}, InputError);
  EXPECT_THROW(CollisionObject(ball_mesh(0), Fidelity::mesh, -1), InputError);
  CollisionObject soft(ball_mesh(0), Fidelity::mesh);
  const std::vector<Vec3> few(3, Vec3::Zero());
  EXPECT_THROW(soft.move(few), InputError);
  EXPECT_THROW(soft.move(ball_mesh(0).positions, few), InputError);
}

}  // namespace
}  // namespace prosector
