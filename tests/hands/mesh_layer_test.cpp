// What rays meet of triangles: the place, the nearer one, its outside.
#include "twins/camera/mesh_layer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/random.h"

namespace prosector {
namespace {

constexpr std::array<Rgb, 3> one_paint = {{{0.5F, 0.25F, 1}, {0.5F, 0.25F, 1}, {0.5F, 0.25F, 1}}};
constexpr std::array<std::array<std::uint32_t, 3>, 1> one_triangle = {{{0, 1, 2}}};

struct Corners {
  std::array<Eigen::Vector3f, 3> positions, normals;
  ShadedMesh mesh() const { return {positions, normals, one_triangle, one_paint}; }
};

/// Returns how far along z a ray meets the triangle; infinite: it doesn't, or from behind.
double met(const Corners& corners, const Vec3& ray) {
  const Vec3 a = corners.positions[0].cast<double>(), b = corners.positions[1].cast<double>() - a,
             c = corners.positions[2].cast<double>() - a;
  Mat3 m;
  m << b, c, -ray;
  const Vec3 x = m.inverse() * -a;
  const bool front = b.cross(c).dot(ray) < 0;
  return front && x[0] > 0 && x[1] > 0 && x[0] + x[1] < 1 ? x[2] : INFINITY;
}

TEST(MeshDepthBuffer, MeetsWhatRaysMeet) {
  Random random(1);
  int compared = 0, missed = 0;
  for (int k = 0; k < 300; ++k) {
    Corners corners;
    for (auto& x : corners.positions) x = (random.point(0.3) + Vec3(0, 0, 0.6)).cast<float>();
    corners.normals.fill(Eigen::Vector3f(0, 0, -1));
    MeshDepthBuffer layer(400, 400, {-1, -1}, {1, 1});
    layer.draw(corners.mesh(), {}, {});
    for (int r = 0; r < 200; ++r) {
      const double a = (static_cast<double>(random.below(400)) + 0.5) / 200 - 1,
                   b = (static_cast<double>(random.below(400)) + 0.5) / 200 - 1;
      const double wanted = met(corners, {a, b, 1});
      const MeshDepthBuffer::Hit hit =
          layer.at(Eigen::Vector2f(static_cast<float>(a), static_cast<float>(b)));
      if (std::isfinite(wanted) != std::isfinite(hit.depth)) {
        ++missed;  // at an edge
      } else if (std::isfinite(wanted)) {
        ++compared;
        ASSERT_NEAR(hit.depth, wanted, 1e-3 * wanted);
      }
    }
  }
  EXPECT_GT(compared, 500);
  EXPECT_LT(missed, compared / 50);
}

TEST(MeshDepthBuffer, ShowsTheNearerAndItsOutsideOnly) {
  const auto square = [](float z, bool turned) {
    Corners out;
    out.positions = {Eigen::Vector3f(-1, -1, z), Eigen::Vector3f(-1, 3, z), Eigen::Vector3f(3, -1, z)};
    if (turned) std::swap(out.positions[1], out.positions[2]);
    out.normals.fill(Eigen::Vector3f(0, 0, -1));
    return out;
  };
  for (const bool near_first : {true, false}) {
    MeshDepthBuffer layer(64, 64, {-0.5, -0.5}, {0.5, 0.5});
    const Corners near = square(0.5F, false), far = square(0.8F, false), behind = square(0.3F, true);
    layer.draw((near_first ? near : far).mesh(), {}, {});
    layer.draw((near_first ? far : near).mesh(), {}, {});
    layer.draw(behind.mesh(), {}, {});
    EXPECT_NEAR(layer.at({0.1F, -0.2F}).depth, 0.5, 1e-5);
    layer.clear();
    EXPECT_TRUE(std::isinf(layer.at({0.1F, -0.2F}).depth));
    EXPECT_TRUE(std::isinf(layer.at({9, 0}).depth));
  }
}

TEST(MeshDepthBuffer, IsLitByLampAndRoom) {
  Corners flat;
  flat.positions = {Eigen::Vector3f(-1, -1, 0.5F), Eigen::Vector3f(-1, 3, 0.5F),
                    Eigen::Vector3f(3, -1, 0.5F)};
  flat.normals.fill(Eigen::Vector3f(0, 0, -1));
  for (const double angle : {0.0, 0.7, 1.2, 2.5}) {
    MeshDepthBuffer layer(8, 8, {-0.5, -0.5}, {0.5, 0.5});
    layer.draw(flat.mesh(), {}, {Vec3(std::sin(angle), 0, -std::cos(angle)), 0.3});
    const double lit = 0.3 + 0.7 * std::max(std::cos(angle), 0.0);
    EXPECT_NEAR(layer.at({0, 0}).light[0], 0.5 * lit, 1e-4);
    EXPECT_NEAR(layer.at({0, 0}).light[1], 0.25 * lit, 1e-4);
  }
}

TEST(MeshDepthBuffer, LeavesOutWhatReachesBehindTheCamera) {
  Corners across;
  across.positions = {Eigen::Vector3f(-1, -1, -0.5F), Eigen::Vector3f(-1, 3, 0.5F),
                      Eigen::Vector3f(3, -1, 0.5F)};
  across.normals.fill(Eigen::Vector3f(0, 0, -1));
  MeshDepthBuffer layer(16, 16, {-1, -1}, {1, 1});
  layer.draw(across.mesh(), {}, {});
  for (float a = -0.9F; a < 1; a += 0.2F) EXPECT_TRUE(std::isinf(layer.at({a, a}).depth));
}

}  // namespace
}  // namespace prosector
