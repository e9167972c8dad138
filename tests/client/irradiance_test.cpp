// Light from around against closed forms.

#include "client/render/irradiance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace prosector {
namespace {

/// Cuts the sphere into patches of equal size.
std::vector<LightPatch> sphere_of(const std::function<Vec3(const Vec3&)>& radiance) {
  constexpr int rings = 120, sides = 240;
  std::vector<LightPatch> out;
  for (int ring = 0; ring < rings; ++ring)
    for (int side = 0; side < sides; ++side) {
      const double y = (2 * ring + 1.0) / rings - 1, angle = 2 * std::numbers::pi * (side + 0.5) / sides;
      const double across = std::sqrt(1 - y * y);
      const Vec3 direction(across * std::cos(angle), y, across * std::sin(angle));
      out.push_back({direction, 4 * std::numbers::pi / (rings * sides), radiance(direction)});
    }
  return out;
}

/// As shaders/lighting.glsl does.
Vec3 arriving(const std::vector<Vec3>& c, const Vec3& n) {
  const double x = n.x(), y = n.y(), z = n.z();
  return c[0] + x * c[1] + y * c[2] + z * c[3] + x * y * c[4] + y * z * c[5] + z * x * c[6] + y * y * c[7] +
         (x * x - z * z) * c[8];
}

const std::vector<Vec3> normals = {Vec3::UnitX(),
                                   Vec3::UnitY(),
                                   -Vec3::UnitY(),
                                   Vec3::UnitZ(),
                                   Vec3(1, 1, 1).normalized(),
                                   Vec3(-0.2, 0.9, 0.4).normalized(),
                                   Vec3(0.7, -0.1, -0.6).normalized()};

TEST(Irradiance, OfEvenLightIsThatLight) {
  const auto all = irradiance_of(sphere_of([](const Vec3&) { return Vec3(0.2, 0.5, 1); }));
  for (const Vec3& n : normals) EXPECT_LT((arriving(all, n) - Vec3(0.2, 0.5, 1)).norm(), 1e-3);
}

// ∫ (ω·a) max(ω·n, 0) dω / π = ⅔ n·a.
TEST(Irradiance, OfLightThatGrowsAlongALineIsTwoThirdsOfIt) {
  const Vec3 a = Vec3(0.3, -0.8, 0.5).normalized();
  const auto all = irradiance_of(sphere_of([&](const Vec3& w) { return Vec3::Constant(w.dot(a)); }));
  for (const Vec3& n : normals) EXPECT_NEAR(arriving(all, n).x(), 2.0 / 3 * n.dot(a), 2e-3);
}

// ∫ P₂(ω·a) max(ω·n, 0) dω / π = ¼ P₂(n·a).
TEST(Irradiance, OfTheSecondOrderIsAQuarterOfIt) {
  const auto p2 = [](double t) { return 1.5 * t * t - 0.5; };
  for (const Vec3& a : normals) {
    const auto all = irradiance_of(sphere_of([&](const Vec3& w) { return Vec3::Constant(p2(w.dot(a))); }));
    for (const Vec3& n : normals) EXPECT_NEAR(arriving(all, n).x(), 0.25 * p2(n.dot(a)), 2e-3);
  }
}

// The upper half shines: (1 + n·y)/2 arrives; what the second order leaves out is below 7 % of that.
TEST(Irradiance, OfAnOpenSkyFollowsTheSlope) {
  const auto all =
      irradiance_of(sphere_of([](const Vec3& w) { return w.y() > 0 ? Vec3(1, 1, 1) : Vec3(0, 0, 0); }));
  for (const Vec3& n : normals) EXPECT_NEAR(arriving(all, n).x(), 0.5 + 0.5 * n.y(), 0.07);
}

}  // namespace
}  // namespace prosector
