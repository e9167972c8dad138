// The outside of what is cut keeps the finer surface that it had: as near to it as stated, without a triangle
// turned over, and to the bit where the cut isn't.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "common/anatomy/implicit.h"
#include "common/anatomy/isosurface.h"
#include "common/anatomy/sources.h"
#include "common/anatomy/stuffing.h"
#include "server/physics/mechanics/collision/surface/triangle_surface.h"
#include "server/physics/mechanics/cutting/skin.h"
#include "server/physics/mechanics/cutting/touched.h"
#include "tests/cutting/meshes.h"
#include "tests/cutting/strokes.h"
#include "tests/real_data.h"

namespace prosector {
namespace {

/// Its outside; positions by vertex slot.
TriangleMesh drawn(const cutting::Skin& skin, const cutting::TetComplex& complex) {
  TriangleMesh out;
  for (const cutting::Skin::Vertex& v : skin.vertices()) {
    Vec3& x = out.positions.emplace_back(Vec3::Zero());
    for (std::size_t k = 0; k < 4; ++k)
      if (v.weight[k] != 0) x += v.weight[k] * complex.rest(v.node[k]);
  }
  for (const cutting::Skin::Triangle& t : skin.triangles())
    if (!t.gone() && !t.inner) out.triangles.push_back(t.corners);
  return out;
}

struct Apart {
  double most = 0, rms = 0;  // m
};

/// Of the one's corners and middles of triangles from the other.
Apart apart(const TriangleMesh& from, const TriangleMesh& to) {
  const collision::TriangleSurface surface(to);
  Apart out;
  double sum = 0;
  std::size_t count = 0;
  const auto look = [&](const Vec3& x) {
    const double d = surface.nearest(x)->distance;
    out.most = std::max(out.most, d);
    sum += d * d;
    ++count;
  };
  for (const auto& t : from.triangles) {
    look((from.positions[t[0]] + from.positions[t[1]] + from.positions[t[2]]) / 3);
    for (const std::uint32_t corner : t) look(from.positions[corner]);
  }
  out.rms = std::sqrt(sum / static_cast<double>(count));
  return out;
}

/// Between a triangle and the fine surface where it is; and the least angle of any, degrees.
struct Quality {
  double least_cosine = 1, least_angle = 180;
};
Quality quality(const TriangleMesh& mesh, const TriangleMesh& fine) {
  const collision::TriangleSurface surface(fine);
  Quality out;
  for (const auto& t : mesh.triangles) {
    const std::array<Vec3, 3> x = {mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]};
    const collision::NearestPoint at = *surface.nearest((x[0] + x[1] + x[2]) / 3);
    const Vec3 normal = (x[1] - x[0]).cross(x[2] - x[0]).normalized();
    out.least_cosine = std::min(out.least_cosine, normal.dot(surface.normal_at(at.triangle, at.weights)));
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 a = (x[(i + 1) % 3] - x[i]).normalized(), b = (x[(i + 2) % 3] - x[i]).normalized();
      out.least_angle = std::min(out.least_angle, 180 / M_PI * std::acos(std::clamp(a.dot(b), -1.0, 1.0)));
    }
  }
  return out;
}

struct Shape {
  const char* name;
  Vec3 size;  // m
  double cell, surface_cell;
  double rms, most;  // m: how far apart the fine surface and the drawn one may be, both ways
};

class OuterShapes : public ::testing::TestWithParam<Shape> {};

TEST_P(OuterShapes, AreTheFineSurface) {
  const Shape& row = GetParam();
  const SolidField field = implicit_shape(row.name, row.size);
  const cutting::TetComplex complex(stuff_solid(field, row.cell), mesh_density);
  const TriangleMesh fine = isosurface(field, row.surface_cell);
  const cutting::Skin skin(complex, std::make_shared<const cutting::OuterShape>(complex, fine));
  const TriangleMesh own = drawn(cutting::Skin(complex), complex), shaped = drawn(skin, complex);
  const Apart to = apart(shaped, fine), from = apart(fine, shaped), before = apart(fine, own);
  RecordProperty(
      "mm", fmt::format("most {:.3f} {:.3f}, rms {:.3f} {:.3f}; the boundary: {:.3f}, {:.3f}", 1e3 * to.most,
                        1e3 * from.most, 1e3 * to.rms, 1e3 * from.rms, 1e3 * before.most, 1e3 * before.rms));
  EXPECT_LT(std::max(to.rms, from.rms), row.rms);
  EXPECT_LT(std::max(to.most, from.most), row.most);
  const Quality good = quality(shaped, fine), was = quality(own, fine);
  EXPECT_GT(good.least_cosine, 0.5);
  EXPECT_GT(good.least_angle, was.least_angle / 2);
  // No more of them than the fine surface has, about.
  EXPECT_LT(static_cast<double>(shaped.triangles.size()), 1.5 * static_cast<double>(fine.triangles.size()));
}

// Of a mesh whose boundary nodes lie on the surface.
TEST_P(OuterShapes, AreNearerThanTheBoundary) {
  const Shape& row = GetParam();
  const SolidField field = implicit_shape(row.name, row.size);
  const cutting::TetComplex complex(stuff(field, row.cell, Vec3::Zero()), mesh_density);
  const TriangleMesh fine = isosurface(field, row.surface_cell);
  const cutting::Skin skin(complex, std::make_shared<const cutting::OuterShape>(complex, fine));
  const Apart from = apart(fine, drawn(skin, complex)),
              before = apart(fine, drawn(cutting::Skin(complex), complex));
  EXPECT_LT(from.rms, before.rms / 2);
}

INSTANTIATE_TEST_SUITE_P(Organs, OuterShapes,
                         ::testing::Values(Shape{"ball", Vec3::Constant(0.1), 0.016, 0.008, 0.3e-3, 0.6e-3},
                                           Shape{"kidney", {0.06, 0.12, 0.05}, 0.01, 0.005, 0.2e-3, 0.6e-3},
                                           Shape{"liver", {0.1, 0.072, 0.083}, 0.01, 0.005, 0.2e-3, 0.9e-3}),
                         [](const auto& info) { return std::string(info.param.name); });

// As in deploy/scenes/cut.toml. The millimetres are where a lobe's edge is thinner than its tetrahedra.
TEST(OuterShape, OfTheCtLiverIsItsFineSurface) {
  SoftDesc liver;
  liver.name = "liver";
  liver.geometry.volume = find_in_data("liver.inr.gz");
  liver.geometry.label = 255;
  liver.geometry.cell = 0.012;
  liver.geometry.surface_cell = 0.006;
  if (liver.geometry.volume.empty()) GTEST_SKIP() << "liver.inr.gz is not below " << default_data_dir();
  const Anatomy anatomy = make_anatomy(liver, {}, {});
  const cutting::TetComplex complex(anatomy.tets, mesh_density);
  const cutting::Skin skin(complex, std::make_shared<const cutting::OuterShape>(complex, anatomy.surface));
  const TriangleMesh shaped = drawn(skin, complex);
  const Apart there = apart(anatomy.surface, shaped), back = apart(shaped, anatomy.surface);
  const auto mm = [](const Apart& a) { return fmt::format("{:.2f}, {:.2f}", 1e3 * a.most, 1e3 * a.rms); };
  RecordProperty("mm", mm(there) + "; " + mm(back));
  EXPECT_LT(there.most, 3.3e-3);
  EXPECT_LT(there.rms, 0.38e-3);
  EXPECT_LT(back.most, 3.3e-3);
  EXPECT_LT(back.rms, 0.17e-3);
}

// A small cut in one side leaves the rest to the bit as it was drawn, in the same slots; where it is, the
// outside stays as near to the fine surface as the boundary was.
TEST(OuterShape, StaysWhereTheCutIsNot) {
  cutting::TetComplex complex(ball_mesh(0.012), mesh_density);
  const TriangleMesh fine = surface_of("ball", 0.006);
  cutting::Skin skin(complex, std::make_shared<const cutting::OuterShape>(complex, fine));
  const std::vector<cutting::Skin::Triangle> before(skin.triangles().begin(), skin.triangles().end());
  const Apart boundary = apart(drawn(cutting::Skin(complex), complex), fine);
  cutting::TetTree tree;
  std::vector<Vec3> x = rest_positions(complex);
  const double middle = mesh_size / 2, deep = 0.8 * mesh_size;
  cutting::BladeStroke blade = cutting::begin_stroke(
      std::vector<Vec3>{{deep, 0.3 * mesh_size, middle}, {0.2, 0.3 * mesh_size, middle}});
  const cutting::CutResult cut = cut_and_carry(
      complex, tree, x, {{deep, 0.6 * mesh_size, middle}, {0.2, 0.6 * mesh_size, middle}}, blade);
  ASSERT_FALSE(cut.ops.empty());
  const cutting::Skin::Change change = skin.follow(complex, cutting::touched_by(complex, cut.ops));
  const TriangleMesh now = drawn(skin, complex);
  std::size_t far = 0;
  for (std::uint32_t slot = 0; slot < before.size(); ++slot) {
    if (before[slot].gone()) continue;
    const Vec3& corner = now.positions[before[slot].corners[0]];
    if (corner.x() > deep - 0.03) continue;  // 2.5 cells
    ++far;
    EXPECT_EQ(skin.triangles()[slot], before[slot]);
  }
  EXPECT_GT(far, before.size() / 2);
  EXPECT_LT(change.triangles.size(), before.size() / 3);
  EXPECT_LT(apart(now, fine).most, boundary.most);
  EXPECT_GT(quality(now, fine).least_cosine, 0.5);
}

// Both sides of a cut right through are drawn at the same places where they meet the outside, on the fine
// surface: nothing gapes or overlaps there.
TEST(OuterShape, WallsMeetTheOutside) {
  cutting::TetComplex complex(ball_mesh(0.016), mesh_density);
  cutting::Skin skin(complex,
                     std::make_shared<const cutting::OuterShape>(complex, surface_of("ball", 0.008)));
  cutting::TetTree tree;
  std::vector<Vec3> x = rest_positions(complex);
  const Stroke stroke = across({0.5, 0.53, 0.5}, {0, 1, 0}, 1);
  cutting::BladeStroke blade = cutting::begin_stroke(stroke[0]);
  cut_and_carry(complex, tree, x, stroke[1], blade);
  skin.update(complex);
  const TriangleMesh now = drawn(skin, complex);
  std::vector<std::uint8_t> kinds(now.positions.size(), 0);
  for (const cutting::Skin::Triangle& t : skin.triangles())
    if (!t.gone())
      for (const std::uint32_t corner : t.corners) kinds[corner] |= t.inner ? 2 : 1;
  std::vector<Vec3> seam;
  for (std::uint32_t v = 0; v < kinds.size(); ++v)
    if (kinds[v] == 3) seam.push_back(now.positions[v]);
  EXPECT_GT(seam.size(), 40U);
  std::size_t alone = 0;
  for (const Vec3& a : seam)
    alone +=
        std::count_if(seam.begin(), seam.end(), [&](const Vec3& b) { return (a - b).norm() < 1e-9; }) < 2;
  EXPECT_EQ(alone, 0U);
}

TEST(OuterShape, IsNoneWhereTheSurfaceIsTheBoundary) {
  const cutting::TetComplex complex(shaken_box(4), mesh_density);
  EXPECT_TRUE(cutting::OuterShape(complex, drawn(cutting::Skin(complex), complex)).is_boundary());
  EXPECT_TRUE(cutting::OuterShape(complex, {}).is_boundary());
  EXPECT_FALSE(
      cutting::OuterShape(cutting::TetComplex(ball_mesh(0.016), mesh_density), surface_of("ball", 0.008))
          .is_boundary());
}

}  // namespace
}  // namespace prosector
