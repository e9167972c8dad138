// Cutting closed surfaces by planes: both sides closed, nothing lost.

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "common/error.h"
#include "common/scene/primitives.h"
#include "server/physics/mechanics/rigid/cut_surface.h"
#include "server/physics/mechanics/rigid/triangulate.h"

namespace prosector {
namespace {

double volume(const TriangleMesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles)
    sum += mesh.positions[t[0]].dot(mesh.positions[t[1]].cross(mesh.positions[t[2]])) / 6;
  return sum;
}

/// Every edge is another triangle's, the other way round. By place: surfaces may come with doubled vertices.
bool closed(const TriangleMesh& mesh) {
  std::map<std::array<double, 6>, int> edges;
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      const Vec3 &a = mesh.positions[t[static_cast<std::size_t>(k)]],
                 &b = mesh.positions[t[static_cast<std::size_t>((k + 1) % 3)]];
      ++edges[{a.x(), a.y(), a.z(), b.x(), b.y(), b.z()}];
      --edges[{b.x(), b.y(), b.z(), a.x(), a.y(), a.z()}];
    }
  return std::all_of(edges.begin(), edges.end(), [](const auto& e) { return e.second == 0; });
}

TriangleMesh primitive(const char* shape, const Vec3& size, double rounding = 0) {
  PartDesc part;
  part.shape = shape;
  part.size = size;
  part.rounding = rounding;
  return mesh_of(part);
}

void append(TriangleMesh& to, const TriangleMesh& from, double scale, bool inside_out) {
  const auto first = static_cast<std::uint32_t>(to.positions.size());
  for (const Vec3& x : from.positions) to.positions.push_back(scale * x);
  for (auto t : from.triangles) {
    if (inside_out) std::swap(t[1], t[2]);
    to.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
}

/// A ring about y: sections have two loops, or a hole.
TriangleMesh ring(double major, double minor, int around, int across) {
  TriangleMesh out;
  const auto at = [&](int i, int j) {
    return static_cast<std::uint32_t>((i % around) * across + j % across);
  };
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double u = 2 * M_PI * i / around, v = 2 * M_PI * j / across;
      const double r = major + minor * std::cos(v);
      out.positions.emplace_back(r * std::cos(u), minor * std::sin(v), r * std::sin(u));
      out.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j)});
      out.triangles.push_back({at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)});
    }
  return out;
}

std::vector<TriangleMesh> solids() {
  TriangleMesh hollow = primitive("sphere", {0.1, 0, 0}), nest = hollow;
  append(hollow, primitive("sphere", {0.1, 0, 0}), 0.7, true);
  append(nest, primitive("box", {0.1, 0.1, 0.1}), 0.3, true);
  append(nest, primitive("sphere", {0.1, 0, 0}), 0.1, false);
  return {primitive("box", {0.1, 0.06, 0.2}),
          primitive("box", {0.1, 0.06, 0.2}, 0.01),
          primitive("cylinder", {0.04, 0.2, 0.04}),
          primitive("capsule", {0.04, 0.2, 0.04}),
          primitive("ellipsoid", {0.1, 0.06, 0.2}),
          ring(0.1, 0.03, 24, 12),
          hollow,
          nest};
}

TEST(CutSurface, BothSidesAreClosedAndFillTheWhole) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> x;
  for (const TriangleMesh& mesh : solids()) {
    ASSERT_TRUE(closed(mesh));
    const double whole = volume(mesh);
    ASSERT_GT(whole, 0);
    for (int i = 0; i < 60; ++i) {
      const Vec3 point = 0.03 * Vec3(x(random), x(random), x(random));
      const Vec3 normal = Vec3(x(random), x(random), x(random)).normalized();
      const rigid::CutSurface cut = rigid::cut_surface(mesh, point, normal);
      EXPECT_TRUE(closed(cut.above));
      EXPECT_TRUE(closed(cut.below));
      EXPECT_NEAR(volume(cut.above) + volume(cut.below), whole, 1e-9 * whole);
      for (const Vec3& p : cut.above.positions) EXPECT_GT(normal.dot(p - point), -1e-8);
      for (const Vec3& p : cut.below.positions) EXPECT_LT(normal.dot(p - point), 1e-8);
    }
  }
}

TEST(CutSurface, AxisAlignedThroughVerticesAndFaces) {
  for (const TriangleMesh& mesh : solids())
    for (const Vec3& normal : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, -1)})
      for (const double at : {0.0, 0.03, 0.05, -0.05, 0.1}) {
        const rigid::CutSurface cut = rigid::cut_surface(mesh, at * normal, normal);
        EXPECT_TRUE(closed(cut.above));
        EXPECT_TRUE(closed(cut.below));
        EXPECT_NEAR(volume(cut.above) + volume(cut.below), volume(mesh), 1e-6 * volume(mesh));
      }
}

TEST(CutSurface, ABoxInHalvesIsTwoBoxes) {
  const rigid::CutSurface cut =
      rigid::cut_surface(primitive("box", {0.1, 0.06, 0.2}), {0.025, 0, 0}, {2, 0, 0});
  EXPECT_NEAR(volume(cut.above), 0.025 * 0.06 * 0.2, 1e-12);
  EXPECT_NEAR(volume(cut.below), 0.075 * 0.06 * 0.2, 1e-12);
}

TEST(CutSurface, WhatIsOpenIsRefused) {
  TriangleMesh open = primitive("box", {0.1, 0.1, 0.1});
  open.triangles.pop_back();
  int refused = 0;
  for (const Vec3& normal : {Vec3(1, 0.1, 0.2), Vec3(0.1, 1, 0.2), Vec3(0.2, 0.1, 1)}) {
    try {
      rigid::cut_surface(open, {0, 0, 0}, normal);
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 0);
}

TEST(CutSurface, APlaneBesideItLeavesItWhole) {
  const TriangleMesh box = primitive("box", {0.1, 0.1, 0.1});
  const rigid::CutSurface cut = rigid::cut_surface(box, {0, 0.2, 0}, {0, 1, 0});
  EXPECT_TRUE(cut.above.triangles.empty());
  EXPECT_NEAR(volume(cut.below), 1e-3, 1e-12);
}

}  // namespace
}  // namespace prosector
