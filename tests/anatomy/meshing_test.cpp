#include <gtest/gtest.h>

#include <cstdio>
#include <numbers>
#include <set>

#include "common/anatomy/bcc_lattice.h"
#include "common/anatomy/boundary_fit.h"
#include "common/anatomy/embedding.h"
#include "common/anatomy/implicit.h"
#include "common/anatomy/isosurface.h"
#include "common/anatomy/kuhn_box.h"
#include "common/anatomy/mesh_quality.h"
#include "common/anatomy/stuffing.h"
#include "common/anatomy/surface_check.h"
#include "common/error.h"

namespace prosector {
namespace {

TEST(KuhnBox, FillsItsBoxWithCongruentTetrahedra) {
  const TetMesh mesh = kuhn_box({0.4, 0.1, 0.2}, 5, 2, 3);
  EXPECT_EQ(mesh.positions.size(), 6u * 3 * 4);
  ASSERT_EQ(mesh.tets.size(), 6u * 5 * 2 * 3);
  const double each = 0.4 * 0.1 * 0.2 / 180;
  std::set<std::array<std::uint32_t, 4>> distinct;
  for (auto t : mesh.tets) {
    const auto& x = mesh.positions;
    EXPECT_NEAR(tet_volume(x[t[0]], x[t[1]], x[t[2]], x[t[3]]), each, 1e-15);
    std::sort(t.begin(), t.end());
    distinct.insert(t);
  }
  EXPECT_EQ(distinct.size(), mesh.tets.size());
  EXPECT_EQ(boundary_faces(mesh).size(), 4u * (5 * 2 + 2 * 3 + 3 * 5));
  EXPECT_EQ(non_manifold_edges(boundary_faces(mesh)), 0u);
  EXPECT_THROW(kuhn_box({1, 1, 1}, 0, 1, 1), InputError);
  EXPECT_THROW(kuhn_box({1, 1, 1}, 4000, 4000, 4000), InputError);
  EXPECT_THROW(kuhn_box({1, -1, 1}, 1, 1, 1), InputError);
}

TEST(TetQuality, RegularTetrahedron) {
  const TetMesh mesh{{{1, 1, 1}, {-1, 1, -1}, {1, -1, -1}, {-1, -1, 1}}, {{0, 1, 2, 3}}};
  TetQuality q = tet_quality(mesh);
  EXPECT_NEAR(std::abs(q.volume), 8.0 / 3, 1e-12);
  EXPECT_NEAR(q.min_dihedral_deg, std::acos(1.0 / 3) * 180 / std::numbers::pi, 1e-9);
  EXPECT_NEAR(q.max_dihedral_deg, q.min_dihedral_deg, 1e-9);
}

// Every shape of the table at several cells and sizes: bounded angles, one piece, manifold boundary, and a
// volume that comes near the field's own.
TEST(Stuffing, EveryShapeAtEveryCell) {
  for (const ImplicitShape& shape : implicit_shapes())
    for (const double stretch : {1.0, 1.3})
      for (const double fraction : {4.0, 7.0}) {
        const Vec3 size = shape.natural_size.cwiseProduct(Vec3(1, stretch, 1));
        const SolidField field = implicit_shape(shape.name, size);
        const double cell = size.minCoeff() / fraction;
        SCOPED_TRACE(std::string(shape.name) + " at " + std::to_string(cell));
        const TetMesh mesh = stuff_solid(field, cell);
        const TetQuality q = tet_quality(mesh);
        EXPECT_GE(q.min_dihedral_deg, 10);
        EXPECT_LE(q.max_dihedral_deg, 165);
        EXPECT_EQ(q.components, 1u);
        EXPECT_EQ(q.non_manifold_edges, 0u);
        for (const auto& t : mesh.tets) {
          const auto& x = mesh.positions;
          ASSERT_GT(tet_volume(x[t[0]], x[t[1]], x[t[2]], x[t[3]]), 0);
        }
      }
}

// Without the fit, the boundary's nodes are on the surface, and faces cut convex parts off.
TEST(Stuffing, BallVolumeConvergesAtSecondOrder) {
  const SolidField ball = implicit_shape("ball", Vec3::Constant(0.1));
  const double exact = 4.0 / 3 * std::numbers::pi * std::pow(0.05, 3);
  const double coarse = 1 - tet_quality(stuff(ball, 0.016, Vec3::Zero())).volume / exact;
  const double fine = 1 - tet_quality(stuff(ball, 0.008, Vec3::Zero())).volume / exact;
  EXPECT_GT(coarse, 0);
  EXPECT_LT(coarse, 0.06);
  EXPECT_LT(fine, coarse / 3);
}

// Exact volumes, m³.
TEST(BoundaryFit, KeepsVolumes) {
  const double of_ball = 4.0 / 3 * std::numbers::pi * std::pow(0.05, 3);
  const Vec3 half(0.05, 0.03, 0.04);
  const SolidField box{[=](const Vec3& x) { return (x.cwiseAbs() - half).maxCoeff(); },
                       {-1.1 * half, 1.1 * half}};
  for (const double cell : {0.016, 0.008}) {
    EXPECT_NEAR(tet_quality(stuff_solid(implicit_shape("ball", Vec3::Constant(0.1)), cell)).volume / of_ball,
                1, 1e-3);
    EXPECT_NEAR(tet_quality(stuff_solid(box, cell)).volume / (8 * half.prod()), 1, 2.5e-3);
  }
}

// Corners of a box are out of reach of a lattice's edges, on which stuff() puts nodes.
TEST(BoundaryFit, FillsCorners) {
  const Vec3 half(0.05, 0.03, 0.04);
  const SolidField box{[=](const Vec3& x) { return (x.cwiseAbs() - half).maxCoeff(); },
                       {-1.1 * half, 1.1 * half}};
  const auto to_corner = [&](const TetMesh& mesh) {  // m, of the corner that is farthest from any node
    double most = 0;
    for (const double x : {-1., 1.})
      for (const double y : {-1., 1.})
        for (const double z : {-1., 1.}) {
          double least = 1;
          for (const Vec3& node : mesh.positions)
            least = std::min(least, (node - Vec3(x, y, z).cwiseProduct(half)).norm());
          most = std::max(most, least);
        }
    return most;
  };
  const double before = to_corner(stuff(box, 0.012, Vec3::Zero())),
               after = to_corner(stuff_solid(box, 0.012));
  std::printf("a node within %.1f mm of each corner, without the fit %.1f mm\n", 1e3 * after, 1e3 * before);
  EXPECT_LT(after, 0.6 * before);
}

/// Returns the mean squared distance (m²) of the boundary faces' centroids from the surface.
double mean_squared_distance(const SolidField& field, const TetMesh& mesh) {
  double sum = 0, area = 0;
  for (const auto& f : boundary_faces(mesh)) {
    const Vec3 &a = mesh.positions[f[0]], &b = mesh.positions[f[1]], &c = mesh.positions[f[2]];
    const double of_face = (b - a).cross(c - a).norm();
    sum += of_face * std::pow(field.value((a + b + c) / 3), 2);
    area += of_face;
  }
  return sum / area;
}

TEST(BoundaryFit, BringsFacesNearerToTheSurface) {
  const SolidField ball{[](const Vec3& x) { return x.norm() - 0.05; },
                        {Vec3::Constant(-0.06), Vec3::Constant(0.06)}};
  const TetMesh before = stuff(ball, 0.016, Vec3::Zero());
  TetMesh after = before;
  fit_boundary(ball, 0.016, after);
  EXPECT_LT(mean_squared_distance(ball, after), mean_squared_distance(ball, before) / 4);
  EXPECT_EQ(after.tets, before.tets);
}

// The unit of a field is free: the fit of a field in millimetres is that of the field in metres.
TEST(BoundaryFit, DoesNotDependOnTheFieldsUnit) {
  const SolidField metres = implicit_shape("kidney", Vec3::Constant(0.1));
  const SolidField others{[&](const Vec3& x) { return 1e3 * metres.value(x); }, metres.box};
  const TetMesh a = stuff_solid(metres, 0.015), b = stuff_solid(others, 0.015);
  ASSERT_EQ(a.positions.size(), b.positions.size());
  for (std::size_t i = 0; i < a.positions.size(); ++i)
    EXPECT_LT((a.positions[i] - b.positions[i]).norm(), 1e-9) << i;
}

TEST(Stuffing, RefusesWhatCannotBeMeshed) {
  const SolidField ball = implicit_shape("ball", Vec3::Constant(0.1));
  EXPECT_THROW(stuff_solid(ball, 1e-6), InputError);
  EXPECT_THROW(stuff_solid(ball, 0), InputError);
  EXPECT_THROW(stuff_solid(ball, -1), InputError);
  const SolidField nothing{[](const Vec3&) { return 1.0; }, {Vec3::Zero(), Vec3::Ones()}};
  EXPECT_THROW(stuff_solid(nothing, 0.1), InputError);
  EXPECT_THROW(isosurface(nothing, 0.1), InputError);
}

/// The number before " mm" that follows `words` in what `make` complains of, in metres.
double cell_named(const std::string& words, const std::function<void()>& make) {
  try {
    make();
  } catch (const InputError& e) {
    const std::string what = e.what();
    const std::size_t at = what.find(words);
    if (at != std::string::npos) return 1e-3 * std::stod(what.substr(at + words.size()));
    ADD_FAILURE() << what;
  }
  return 0;
}

TEST(Stuffing, NamesAFinerCellThatDoesGiveTetrahedra) {
  for (const ImplicitShape& shape : implicit_shapes())
    for (const double thinness : {1.0, 0.2}) {
      const SolidField field =
          implicit_shape(shape.name, shape.natural_size.cwiseProduct(Vec3(1, thinness, 1)));
      double cell = 2 * field.box.size().maxCoeff();
      SCOPED_TRACE(std::string(shape.name) + " at " + std::to_string(cell));
      try {
        stuff_solid(field, cell);
        continue;  // a shape that fills its box has tetrahedra at any cell
      } catch (const InputError&) {
      }
      cell = cell_named("e.g. ", [&] { stuff_solid(field, cell); });
      EXPECT_GT(cell, 0);
      EXPECT_NO_THROW(stuff_solid(field, cell));
    }
}

TEST(Stuffing, RefusesWhatIsTooManyBeforeItMakesThem) {
  const SolidField ball = implicit_shape("ball", Vec3::Ones());
  EXPECT_NEAR(expected_tets(ball, 0.05), static_cast<double>(stuff_solid(ball, 0.05).tets.size()),
              0.1 * expected_tets(ball, 0.05));
  int asked = 0;
  const SolidField counted{[&](const Vec3& x) { return ++asked, ball.value(x); }, ball.box};
  const double allowed = cell_named("a cell of ", [&] {
    try {
      stuff_solid(counted, 5e-4);
    } catch (const InputError& e) {
      throw InputError(std::string(e.what()).substr(std::string(e.what()).find("allowed: ")));
    }
  });
  EXPECT_GT(allowed, 5e-4);
  EXPECT_LT(expected_tets(ball, allowed), max_tets);
  EXPECT_LT(lattice_points(ball.box.size(), allowed), 1 << 23);
  EXPECT_LT(asked, 20000);  // of 10^10 lattice points
  asked = 0;
  EXPECT_THROW(isosurface(counted, 5e-4), InputError);
  EXPECT_EQ(asked, 0);
}

TEST(Isosurface, EveryShapeIsClosedAndAboutItsCell) {
  for (const ImplicitShape& shape : implicit_shapes()) {
    SCOPED_TRACE(shape.name);
    const SolidField field = implicit_shape(shape.name, shape.natural_size);
    const double cell = shape.natural_size.minCoeff() / 14;
    const TriangleMesh mesh = isosurface(field, cell);
    const SurfaceReport report = check_surface(mesh);
    EXPECT_EQ(report.open_edges, 0u);
    EXPECT_EQ(report.intersecting_pairs, 0u);
    EXPECT_GT(report.volume, 0);
    double sum = 0;
    for (const auto& t : mesh.triangles)
      for (std::size_t k = 0; k < 3; ++k)
        sum += (mesh.positions[t[k]] - mesh.positions[t[(k + 1) % 3]]).norm();
    EXPECT_NEAR(sum / static_cast<double>(3 * mesh.triangles.size()), cell, 0.3 * cell);
    std::size_t off = 0;
    for (const Vec3& x : mesh.positions) {
      ASSERT_LT(std::abs(field.value(x)), cell);
      if (std::abs(field.value(x)) > 0.1 * cell) ++off;
    }
    EXPECT_LE(off, mesh.positions.size() / 100);  // creases only
  }
}

TEST(Implicit, BoxIsTheSizeAskedFor) {
  for (const ImplicitShape& shape : implicit_shapes()) {
    SCOPED_TRACE(shape.name);
    const Vec3 size(0.2, 0.15, 0.3);
    const TriangleMesh mesh = isosurface(implicit_shape(shape.name, size), 0.012);
    Vec3 low = mesh.positions.front(), high = low;
    for (const Vec3& x : mesh.positions) {
      low = low.cwiseMin(x);
      high = high.cwiseMax(x);
    }
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(high[k] - low[k], size[k], 0.1 * size[k]) << k;
  }
  EXPECT_THROW(implicit_shape("spleen", Vec3::Ones()), InputError);
  EXPECT_THROW(implicit_shape("ball", {1, 0, 1}), InputError);
}

TEST(Embedding, RowsSumToOneAndReproduceTheSurface) {
  for (const char* name : {"liver", "gallbladder", "foot"}) {
    const Vec3 size = natural_size(name);
    const SolidField field = implicit_shape(name, size);
    const double cell = size.minCoeff() / 6;
    const TriangleMesh surface = isosurface(field, cell / 2);
    const Embedding e = embed(stuff_solid(field, cell), surface);
    const Anatomy& a = e.anatomy;
    ASSERT_EQ(a.embedding.rows.size(), surface.positions.size());
    std::size_t moved = 0;
    for (std::size_t i = 0; i < surface.positions.size(); ++i) {
      const SparseMap::Row& row = a.embedding.rows[i];
      EXPECT_NEAR(row.weight[0] + row.weight[1] + row.weight[2] + row.weight[3], 1, 1e-12);
      for (const double w : row.weight) EXPECT_LE(std::abs(w), max_embedding_weight + 1e-9);
      EXPECT_EQ(a.surface.positions[i], a.embedding.apply(i, a.tets.positions[0].data()));
      if ((a.surface.positions[i] - surface.positions[i]).norm() > 1e-9) ++moved;
    }
    EXPECT_EQ(moved, e.drawn_in) << name;
  }
}

TEST(Embedding, LinearMapsCarryOver) {
  Anatomy a = embed(kuhn_box({1, 1, 1}, 3, 3, 3),
                    {{{0.2, 0.3, 0.4}, {1.1, 0.5, 0.5}, {-0.1, -0.1, 1.2}}, {{0, 1, 2}}})
                  .anatomy;
  const auto rest = a.surface.positions;
  Mat3 f;
  f << 1, 2, 0, 0.5, 1, -1, 0, 0.25, 3;
  for (Vec3& x : a.tets.positions) x = f * x;
  apply_embedding(a);
  for (std::size_t i = 0; i < rest.size(); ++i)
    EXPECT_LT((a.surface.positions[i] - f * rest[i]).norm(), 1e-12);
}

}  // namespace
}  // namespace prosector
