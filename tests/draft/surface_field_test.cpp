// Signed distances to closed surfaces, against closed forms.

#include "common/anatomy/surface_field.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "common/anatomy/mesh_quality.h"
#include "common/anatomy/stuffing.h"
#include "common/anatomy/surface_repair.h"
#include "common/error.h"
#include "tests/draft/surface_texts.h"

namespace prosector {
namespace {

double to_box(const Vec3& x, const Vec3& low, const Vec3& high) {
  const Vec3 q = (x - 0.5 * (low + high)).cwiseAbs() - 0.5 * (high - low);
  return q.cwiseMax(0).norm() + std::min(q.maxCoeff(), 0.);
}

TEST(SurfaceField, IsTheDistanceToABox) {
  const Vec3 low(-0.1, 0, 0.05), high(0.2, 0.1, 0.09);
  TriangleMesh inward = box_surface(low, high);
  for (auto& t : inward.triangles) std::swap(t[0], t[1]);
  for (const TriangleMesh& mesh : {box_surface(low, high), inward}) {
    const SolidField field = solid_within(mesh);
    EXPECT_EQ(field.box.min, low);
    EXPECT_EQ(field.box.max, high);
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> at(-0.3, 0.4);
    for (int i = 0; i < 5000; ++i) {
      const Vec3 x(at(random), at(random), at(random));
      EXPECT_NEAR(field.value(x), to_box(x, low, high), 1e-12) << x.transpose();
    }
  }
}

TEST(SurfaceField, IsTheDistanceToABall) {
  constexpr double r = 0.1;
  const TriangleMesh mesh = surface_of("ball", Vec3::Constant(2 * r), 0.01);
  double within = r;  // the radius of the largest ball inside the triangles
  for (const auto& t : mesh.triangles) {
    const Vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    within = std::min(within, (b - a).cross(c - a).normalized().dot(a));
  }
  const SolidField field = solid_within(mesh);
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> at(-0.2, 0.2);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 x(at(random), at(random), at(random));
    EXPECT_GT(field.value(x), x.norm() - r - 1e-5);
    EXPECT_LT(field.value(x), x.norm() - within + 1e-5);
  }
  EXPECT_LT(r - within, 1e-3);
}

TEST(SurfaceField, FillsWhatItBounds) {
  const double r = 0.06;
  const TetMesh tets = stuff_solid(solid_within(surface_of("ball", Vec3::Constant(2 * r), 0.006)), 0.01);
  const TetQuality quality = tet_quality(tets);
  EXPECT_NEAR(quality.volume, 4. / 3 * std::numbers::pi * r * r * r, 0.03 * quality.volume);
  EXPECT_EQ(quality.components, 1u);
}

TEST(SurfaceField, SaysWhatKeepsASurfaceOpen) {
  const auto faults = [](const auto& spoil) {
    TriangleMesh mesh = box_surface(Vec3::Zero(), Vec3::Ones());
    spoil(mesh);
    return surface_faults(mesh);
  };
  EXPECT_FALSE(faults([](TriangleMesh&) {}));
  const SurfaceFaults hole = faults([](TriangleMesh& m) { m.triangles.pop_back(); });
  EXPECT_EQ(hole.hole_edges, 3u);
  EXPECT_EQ(hole.crowded_edges + hole.opposed_edges, 0u);
  EXPECT_NE(hole.in_words().find("3 edges at the borders of holes"), std::string::npos);
  const SurfaceFaults crowded = faults([](TriangleMesh& m) { m.triangles.push_back(m.triangles.front()); });
  EXPECT_EQ(crowded.crowded_edges, 3u);
  const SurfaceFaults turned =
      faults([](TriangleMesh& m) { std::swap(m.triangles[0][0], m.triangles[0][1]); });
  EXPECT_EQ(turned.opposed_edges, 3u);
  TriangleMesh open = box_surface(Vec3::Zero(), Vec3::Ones());
  open.triangles.pop_back();
  EXPECT_THROW(solid_within(open), InputError);
}

TEST(SurfaceField, CountsSolids) {
  TriangleMesh two = box_surface(Vec3::Zero(), Vec3::Ones());
  EXPECT_EQ(solid_shells(two).solids.size(), 1u);
  EXPECT_NEAR(enclosed_volume(two), 1, 1e-12);
  append(two, box_surface(Vec3::Constant(2), Vec3::Constant(4)));
  EXPECT_EQ(solid_shells(two).solids.size(), 2u);
  EXPECT_NEAR(enclosed_volume(two), 9, 1e-12);
}

}  // namespace
}  // namespace prosector
