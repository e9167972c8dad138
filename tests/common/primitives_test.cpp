// Every primitive, with and without rounding: closed, outward, of the right size and volume.

#include "common/scene/primitives.h"

#include <gtest/gtest.h>

#include <map>
#include <numbers>

#include "common/error.h"

namespace prosector {
namespace {

double volume(const TriangleMesh& mesh) {
  double v = 0;
  for (const auto& t : mesh.triangles)
    v += mesh.positions[t[0]].dot(mesh.positions[t[1]].cross(mesh.positions[t[2]])) / 6;
  return v;
}

void expect_closed(const TriangleMesh& mesh, const std::string& what) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
  for (const auto& [edge, count] : edges) {
    ASSERT_EQ(count, 1) << what;
    ASSERT_TRUE(edges.contains({edge.second, edge.first})) << what << ": open or inconsistent edge";
  }
}

Vec3 extent(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vec3& x : mesh.positions) box.extend(x);
  return box.sizes();
}

PartDesc part(const std::string& shape, const Vec3& size, double rounding = 0) {
  PartDesc p;
  p.shape = shape;
  p.size = size;
  p.rounding = rounding;
  return p;
}

struct Case {
  PartDesc part;
  Vec3 extent;
  double volume;
  double tolerance;  // relative, of the volume
};

TEST(Primitives, AreClosedOutwardAndOfTheirSize) {
  constexpr double pi = std::numbers::pi;
  const std::vector<Case> cases = {
      {part("box", {0.2, 0.1, 0.4}), {0.2, 0.1, 0.4}, 0.2 * 0.1 * 0.4, 1e-12},
      {part("box", {0.2, 0.1, 0.4}, 0.01), {0.2, 0.1, 0.4}, 0.2 * 0.1 * 0.4, 0.02},
      {part("box", {0.1, 0.1, 0.1}, 1), {0.1, 0.1, 0.1}, pi / 6 * 1e-3, 0.05},  // all rounding: a sphere
      {part("box", {0.02, 0.1, 0.1}, 0.01), {0.02, 0.1, 0.1}, 1.7e-4, 0.1},
      {part("sphere", {0.3, 0, 0}), {0.3, 0.3, 0.3}, pi / 6 * 0.027, 0.01},
      {part("ellipsoid", {0.3, 0.2, 0.1}), {0.3, 0.2, 0.1}, pi / 6 * 0.006, 0.01},
      {part("capsule", {0.1, 0.3, 0}), {0.1, 0.3, 0.1}, pi * 0.0025 * (0.2 + 0.2 / 3), 0.02},
      {part("capsule", {0.1, 0.1, 0}), {0.1, 0.1, 0.1}, pi / 6 * 1e-3, 0.02},
      {part("cylinder", {0.1, 0.3, 0}), {0.1, 0.3, 0.1}, pi * 0.0025 * 0.3, 0.01},
      {part("cylinder", {0.1, 0.3, 0}, 0.005), {0.1, 0.3, 0.1}, pi * 0.0025 * 0.3, 0.01},
      {part("cylinder", {0.1, 0.3, 0}, 10), {0.1, 0.3, 0.1}, pi * 0.0025 * (0.2 + 0.2 / 3), 0.03},
  };
  for (const Case& c : cases) {
    const std::string what = c.part.shape + " rounding " + std::to_string(c.part.rounding);
    const TriangleMesh mesh = mesh_of(c.part);
    expect_closed(mesh, what);
    EXPECT_NEAR((extent(mesh) - c.extent).norm(), 0, 1e-3 * c.extent.norm()) << what;
    EXPECT_NEAR(volume(mesh), c.volume, c.tolerance * c.volume) << what;
    for (const auto& t : mesh.triangles)
      EXPECT_GT((mesh.positions[t[1]] - mesh.positions[t[0]])
                    .cross(mesh.positions[t[2]] - mesh.positions[t[0]])
                    .norm(),
                1e-14)
          << what << ": degenerate triangle";
  }
}

TEST(Primitives, RoundSurfacesKeepTheirChordError) {
  const TriangleMesh mesh = mesh_of(part("cylinder", {0.1, 0.1, 0}));
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 a = mesh.positions[t[k]], b = mesh.positions[t[(k + 1) % 3]];
      if (std::hypot(a.x(), a.z()) < 0.04 || std::hypot(b.x(), b.z()) < 0.04) continue;  // a cap's spoke
      const Vec3 middle = (a + b) / 2;
      EXPECT_GT(std::hypot(middle.x(), middle.z()), 0.05 - chord_error - 1e-12);
    }
}

TEST(Primitives, ArePlacedInTheBodysFrameAndConcatenated) {
  PartDesc a = part("box", {0.1, 0.2, 0.3}), b = part("sphere", {0.1, 0, 0});
  a.pose = {{1, 2, 3}, Quat(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitZ()))};
  b.pose.p = {0, 0, -1};
  EXPECT_NEAR((extent(mesh_of(a)) - Vec3(0.2, 0.1, 0.3)).norm(), 0, 1e-12);
  const std::vector<PartDesc> parts = {a, b};
  const TriangleMesh both = mesh_of(parts);
  EXPECT_EQ(both.positions.size(), mesh_of(a).positions.size() + mesh_of(b).positions.size());
  expect_closed(both, "two parts");
  EXPECT_NEAR(volume(both), volume(mesh_of(a)) + volume(mesh_of(b)), 1e-12);
  EXPECT_TRUE(mesh_of(std::span<const PartDesc>{}).positions.empty());
}

TEST(Primitives, RefuseUnknownShapesAndBadSizes) {
  const std::vector<PartDesc> bad = {part("torus", {1, 1, 1}), part("box", {1, 0, 1}),
                                     part("sphere", {-1, 1, 1}), part("capsule", {1, std::nan(""), 1}),
                                     part("ellipsoid", {1, 1, 0})};
  for (const PartDesc& p : bad) EXPECT_THROW(mesh_of(p), InputError) << p.shape;
  EXPECT_NO_THROW(mesh_of(part("sphere", {1, 0, 0})));
}

}  // namespace
}  // namespace prosector
