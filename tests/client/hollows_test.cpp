// Hollows against surfaces of known curvature.

#include "client/render/curvature.h"

#include <gtest/gtest.h>

#include "tests/client/picture.h"

namespace prosector {
namespace {

using namespace test;

constexpr double scale = 0.004;  // m, as curvature_of() takes it

/// Turns a surface inside out.
Triangles turned(Triangles triangles) {
  for (auto& t : triangles) std::swap(t[1], t[2]);
  return triangles;
}

TEST(Hollows, OfABallAreItsCurvature) {
  for (const double radius : {0.02, 0.05, 0.1}) {
    const auto ball = sphere_mesh(radius, 1);
    const std::vector<float> outside = curvature_of(ball->positions, ball->triangles);
    const std::vector<float> inside = curvature_of(ball->positions, turned(ball->triangles));
    ASSERT_EQ(outside.size(), ball->positions.size());
    for (std::size_t v = 0; v < outside.size(); ++v) {
      EXPECT_NEAR(outside[v], -scale / radius, 0.08 * scale / radius) << radius;
      EXPECT_NEAR(inside[v], scale / radius, 0.08 * scale / radius) << radius;
    }
  }
}

TEST(Hollows, OfAPlaneAreNone) {
  constexpr int side = 6;
  std::vector<Eigen::Vector3f> points;
  Triangles triangles;
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x) {
      points.emplace_back(0.01F * static_cast<float>(x), 0.3F, 0.02F * static_cast<float>(y));
      if (x + 1 == side || y + 1 == side) continue;
      const std::uint32_t a = y * side + x, b = a + side;
      triangles.push_back({a, b, a + 1});
      triangles.push_back({a + 1, b, b + 1});
    }
  for (const float hollow : curvature_of(points, triangles)) EXPECT_NEAR(hollow, 0, 1e-6);
}

TEST(Hollows, OfNoAreaAreNone) {
  const std::vector<Eigen::Vector3f> points(3, Eigen::Vector3f::Zero());
  for (const float hollow : curvature_of(points, Triangles{{0, 1, 2}})) EXPECT_EQ(hollow, 0);
}

}  // namespace
}  // namespace prosector
