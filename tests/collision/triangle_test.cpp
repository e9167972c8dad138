// Two triangles: where they cross, and their closest points.

#include <gtest/gtest.h>

#include "server/physics/mechanics/collision/primitives/triangle_crossing.h"
#include "tests/collision/shapes.h"

namespace prosector {
namespace {

using namespace test;

collision::Triangle random_triangle(Random& random, double size) {
  return {random_point(random, size), random_point(random, size), random_point(random, size)};
}

// Exact: corners are whole numbers, and two triangles with an area are apart if and only if one of these 17
// axes parts them.
struct Whole {
  std::int64_t x, y, z;
  Whole operator-(const Whole& b) const { return {x - b.x, y - b.y, z - b.z}; }
  Whole cross(const Whole& b) const { return {y * b.z - z * b.y, z * b.x - x * b.z, x * b.y - y * b.x}; }
  std::int64_t dot(const Whole& b) const { return x * b.x + y * b.y + z * b.z; }
  bool zero() const { return x == 0 && y == 0 && z == 0; }
  Vec3 real() const { return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)}; }
};
using WholeTriangle = std::array<Whole, 3>;

Whole normal_of(const WholeTriangle& t) {
  return (t[1] - t[0]).cross(t[2] - t[0]);
}

bool cross_exactly(const WholeTriangle& a, const WholeTriangle& b) {
  std::vector<Whole> axes{normal_of(a), normal_of(b)};
  for (std::size_t i = 0; i < 3; ++i) {
    const Whole e = a[(i + 1) % 3] - a[i];
    axes.push_back(normal_of(a).cross(e));
    axes.push_back(normal_of(b).cross(b[(i + 1) % 3] - b[i]));
    for (std::size_t j = 0; j < 3; ++j) axes.push_back(e.cross(b[(j + 1) % 3] - b[j]));
  }
  for (const Whole& n : axes) {
    if (n.zero()) continue;
    const auto [lo_a, hi_a] = std::minmax({n.dot(a[0]), n.dot(a[1]), n.dot(a[2])});
    const auto [lo_b, hi_b] = std::minmax({n.dot(b[0]), n.dot(b[1]), n.dot(b[2])});
    if (hi_a < lo_b || hi_b < lo_a) return false;
  }
  return true;
}

WholeTriangle whole_triangle(Random& random, int size) {
  std::uniform_int_distribution<int> number(-size, size);
  for (;;) {
    WholeTriangle t;
    for (Whole& c : t) c = {number(random), number(random), number(random)};
    if (!normal_of(t).zero()) return t;
  }
}

collision::Triangle real(const WholeTriangle& t) {
  return {t[0].real(), t[1].real(), t[2].real()};
}

TEST(TriangleCrossing, AgreesWithExactArithmeticWhereMuchIsDegenerate) {
  Random random(1);
  for (const int size : {1, 2, 4, 50}) {
    int crossing_ones = 0;
    for (int i = 0; i < 20000; ++i) {
      const WholeTriangle a = whole_triangle(random, size), b = whole_triangle(random, size);
      const bool expected = cross_exactly(a, b);
      ASSERT_EQ(collision::crossing(real(a), real(b)).crosses, expected) << size << " " << i;
      ASSERT_EQ(collision::crossing(real(b), real(a)).crosses, expected) << size << " " << i;
      crossing_ones += expected;
    }
    EXPECT_GT(crossing_ones, 1000);
  }
}

TEST(TriangleCrossing, PiercingsLieOnBoth) {
  Random random(2);
  for (int i = 0; i < 20000; ++i) {
    const collision::Triangle a = random_triangle(random, 1), b = random_triangle(random, 1);
    const collision::TriangleCrossing found = collision::crossing(a, b);
    ASSERT_EQ(found.crosses, found.count > 0);
    for (std::size_t k = 0; k < found.count; ++k) {
      const collision::Piercing& p = found.piercings[k];
      const collision::Triangle &edges = p.of_a ? a : b, &face = p.of_a ? b : a;
      const Vec3 on_edge = edges[p.edge] + p.along * (edges[(p.edge + 1u) % 3] - edges[p.edge]);
      EXPECT_LT((on_edge - p.point).norm(), 1e-12);
      const Vec3 weights = collision::closest_weights(p.point, face[0], face[1], face[2]);
      EXPECT_LT((collision::at(face, weights) - p.point).norm(), 1e-9);
    }
  }
}

TEST(TriangleCrossing, FlatAndPointTriangles) {
  const collision::Triangle t{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  const auto point = [](double x, double y, double z) {
    return collision::Triangle{Vec3(x, y, z), Vec3(x, y, z), Vec3(x, y, z)};
  };
  EXPECT_TRUE(collision::crossing(t, t).crosses);
  EXPECT_TRUE(collision::crossing(t, point(0.25, 0.25, 0)).crosses);
  EXPECT_FALSE(collision::crossing(t, point(0.25, 0.25, 1e-9)).crosses);
  EXPECT_FALSE(collision::crossing(t, point(0.75, 0.75, 0)).crosses);
  const collision::Triangle needle{Vec3(0.2, 0.2, -1), Vec3(0.2, 0.2, 0), Vec3(0.2, 0.2, 1)};
  EXPECT_TRUE(collision::crossing(t, needle).crosses);
  EXPECT_TRUE(collision::crossing(needle, t).crosses);
}

/// Two convex sets' closest points are where the planes across the way between them have the sets on either
/// side; that holds for nothing else.
void expect_closest(const collision::Triangle& a, const collision::Triangle& b,
                    const collision::TrianglePair& pair) {
  const Vec3 way = pair.on_a - pair.on_b;
  const double d = way.norm();
  ASSERT_NEAR(d * d, pair.squared_distance, 1e-12);
  EXPECT_LT((collision::at(a, pair.weights_a) - pair.on_a).norm(), 1e-12);
  EXPECT_LT((collision::at(b, pair.weights_b) - pair.on_b).norm(), 1e-12);
  for (const Vec3& x : a) EXPECT_GE(way.dot(x - pair.on_a), -1e-9 * d);
  for (const Vec3& x : b) EXPECT_LE(way.dot(x - pair.on_b), 1e-9 * d);
}

TEST(ClosestTriangles, HavePlanesBetweenThem) {
  Random random(3);
  for (int i = 0; i < 20000; ++i) {
    const collision::Triangle a = random_triangle(random, 1);
    collision::Triangle b = random_triangle(random, 1);
    if (i % 4 == 1) b[2] = b[1];  // a segment
    if (i % 4 == 2)
      for (std::size_t k = 0; k < 3; ++k) b[k] = a[k] + Vec3(0, 0, 1);  // parallel
    if (i % 4 == 3) b[2] = b[1] = b[0];                                 // a point
    if (!collision::crossing(a, b).crosses) expect_closest(a, b, collision::closest(a, b));
  }
}

}  // namespace
}  // namespace prosector
