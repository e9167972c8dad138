// What is drawn of tissue before and after a cut.

#include "client/view/soft_body_mesh.h"

#include <gtest/gtest.h>

#include "client/view/wireframe.h"

namespace prosector {
namespace {

/// A square of two triangles on its four corners.
SoftReplica square() {
  const std::vector<Vec3> corners = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  SceneBody body;
  body.points = 4;
  body.chunk_points = 3;
  StreamedSurface streamed{corners, {}};
  for (std::uint32_t v = 0; v < 4; ++v) streamed.map.rows.push_back({{v}, {1}});
  SoftReplica out(body, {corners, {{0, 1, 2}, {0, 2, 3}}}, streamed);
  out.add(Settled{.body = 0,
                  .time = {0, 1},
                  .revision = 0,
                  .hash = 0,
                  .positions = {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}});
  return out;
}

/// One triangle goes, an inner one comes on a new point.
SurfacePatch cut() {
  SurfacePatch out;
  out.points = {{{0, 0, -1}, {0, 0, 0.5f}}};
  out.vertices = {{4, {0, 0, -1}, {4, 0, 0, 0}, {1, 0, 0, 0}}};
  out.triangles = {{1, {0, 0, 0}, false}, {2, {0, 2, 4}, true}};
  return out;
}

TEST(SoftBodyMesh, IsTheWholeSurfaceWhileUncut) {
  SoftReplica soft = square();
  SoftBodyMesh mesh(soft, 0, 7);
  EXPECT_TRUE(soft.sample(1, 1));
  mesh.follow(soft, true);
  EXPECT_EQ(mesh.outer()->id, 7u);
  EXPECT_EQ(mesh.outer()->triangles.size(), 2u);
  EXPECT_EQ(mesh.outer()->positions[2], Eigen::Vector3f(1, 1, 1));
  EXPECT_EQ(mesh.inner(), nullptr);
  const auto before = mesh.outer()->positions_revision;
  mesh.follow(soft, false);
  EXPECT_EQ(mesh.outer()->positions_revision, before);
}

TEST(SoftBodyMesh, WhatACutLaidBareHasItsOwnVerticesAndNormals) {
  SoftReplica soft = square();
  SoftBodyMesh mesh(soft, 0, 7);
  soft.sample(1, 1);
  mesh.follow(soft, true);
  DrawnSurface next = soft.drawn();
  apply(cut(), next);
  soft.follow(next, cut(), 1, {0, 2});
  ASSERT_TRUE(soft.sample(2, 1)) << "another surface has to be drawn anew, moved or not";
  mesh.follow(soft, true);
  EXPECT_EQ(mesh.outer()->revision, 1u);
  ASSERT_EQ(mesh.outer()->triangles.size(), 1u);
  ASSERT_NE(mesh.inner(), nullptr);
  EXPECT_EQ(mesh.inner()->id, 8u);
  EXPECT_EQ(mesh.inner()->triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}}));
  EXPECT_EQ(mesh.inner()->positions[1], Eigen::Vector3f(1, 1, 1));
  EXPECT_EQ(mesh.inner()->positions[2], Eigen::Vector3f(0, 0, 0.5f)) << "where the patch says that it is";
  EXPECT_EQ(mesh.inner()->rest_positions[2], Eigen::Vector3f(0, 0, -1));
  EXPECT_LT((mesh.outer()->normals[0] - Eigen::Vector3f::UnitZ()).norm(), 1e-6f);
  EXPECT_LT(std::abs(mesh.inner()->normals[0].z()), 1e-6f) << "a crease where the two meet";
  EXPECT_EQ(all_edges(soft.rest().triangles).size(), 5u);  // none of the triangle that is gone
}

TEST(SoftBodyMesh, TheInsideIsDarkerAndWetterAndHasNoSkin) {
  const Appearance skin{.color = {0.8, 0.6, 0.5}, .roughness = 0.7, .wetness = 0.1, .surface = Surface::skin};
  const Appearance inside = inner_appearance(skin);
  EXPECT_LT(inside.color.sum(), skin.color.sum());
  EXPECT_GT(inside.wetness, skin.wetness);
  EXPECT_EQ(inside.surface, Surface::tissue);
}

}  // namespace
}  // namespace prosector
