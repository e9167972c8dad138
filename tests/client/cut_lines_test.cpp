// The line of a cut: where it is found, how long it is, and when it is drawn.

#include "client/view/cut_lines.h"

#include <gtest/gtest.h>

#include <cmath>

#include "client/replica/stroke_figures.h"
#include "client/view/blade_frame.h"
#include "client/view/camera.h"

namespace prosector {
namespace {

/// A strip of the plane y = 0 that a cut along z = 0 opened from x = 0 to x = 0.1, with a wall on each side.
TriangleMesh opened(double gap = 0) {
  TriangleMesh out;
  const double half = gap / 2;
  out.positions = {{0, 0, half},  {0.1, 0, half},  {0, -0.02, half},  {0.1, -0.02, half},
                   {0, 0, -half}, {0.1, 0, -half}, {0, -0.02, -half}, {0.1, -0.02, -half},
                   {0, 0, 0.05},  {0.1, 0, 0.05},  {0, 0, -0.05},     {0.1, 0, -0.05}};
  out.triangles = {{0, 8, 9}, {0, 9, 1}, {4, 5, 11}, {4, 11, 10},  // outside
                   {0, 1, 3}, {0, 3, 2}, {4, 6, 7},  {4, 7, 5}};   // walls
  out.inner = {0, 0, 0, 0, 1, 1, 1, 1};
  return out;
}

/// The same as a sheet, which has no walls.
TriangleMesh parted_sheet() {
  TriangleMesh out = opened();
  out.triangles.resize(4);
  out.inner.clear();
  return out;
}

SoftReplica replica_of(const TriangleMesh& rest, const TriangleMesh& now) {
  SceneBody body;
  body.points = static_cast<std::uint32_t>(rest.positions.size());
  body.chunk_points = body.points;
  StreamedSurface streamed{rest.positions, {}};
  for (std::uint32_t v = 0; v < rest.positions.size(); ++v) streamed.map.rows.push_back({{v}, {1}});
  SoftReplica out(body, rest, streamed);
  out.begin_at(1);
  Settled settled{.body = 0, .time = {0, 1}, .revision = 1, .hash = 0, .positions = {}};
  for (const Vec3& x : now.positions) settled.positions.push_back(x.cast<float>());
  out.add(settled);
  out.sample(1, 1);
  return out;
}

DrawMesh drawn(const SoftReplica& soft) {
  DrawMesh out;
  out.positions = soft.surface();
  out.normals.assign(out.positions.size(), Eigen::Vector3f::UnitY());
  return out;
}

DrawList seen_from_above() {
  DrawList out;
  out.cameras.push_back(mono_camera(look_at({0.05, 0.5, 0}, {0.05, 0, 0.001}), 0.8, 800, 600));
  return out;
}

std::size_t lines_of(const TriangleMesh& rest, const TriangleMesh& now) {
  const SoftReplica soft = replica_of(rest, now);
  const DrawMesh mesh = drawn(soft);
  CutLines lines;
  lines.begin();
  lines.put(0, soft, mesh, {});
  DrawList list = seen_from_above();
  lines.add(list);
  for (const DrawLine& line : list.lines) {
    EXPECT_GE(line.width, 1.5);
    EXPECT_LT(line.color.maxCoeff(), 0.05) << "dark";
    EXPECT_GT(line.color.x(), 3 * line.color.y()) << "red";
    EXPECT_NEAR((line.b - line.a).norm(), 0.1, 2e-3);
  }
  return list.lines.size();
}

TEST(CutRims, AreWhereWallsMeetTheOutside) {
  const std::vector<CutRim> rims = cut_rims(opened());
  ASSERT_EQ(rims.size(), 2u);
  EXPECT_EQ(rims[0].a + rims[0].b, 1u);
  EXPECT_EQ(rims[1].a + rims[1].b, 9u);
  EXPECT_TRUE(cut_rims({}).empty());
}

TEST(CutRims, HaveTheirOtherSideWhereTheyWereOne) {
  const std::vector<RestEdge> edges = {
      {{0, 0, 0}, {1, 0, 0}}, {{0, 0, 1}, {1, 0, 1}}, {{1, 0, 1e-7}, {0, 0, 0}}, {{0, 0, 0}, {0, 1, 0}}};
  const auto others = other_sides(edges);
  ASSERT_TRUE(others[0] && others[2]);
  EXPECT_EQ(others[0]->edge, 2u);
  EXPECT_EQ(others[2]->edge, 0u);
  EXPECT_EQ(others[0]->share, 0.5);
  EXPECT_FALSE(others[1]);
  EXPECT_FALSE(others[3]);
}

TEST(CutRims, HaveTheirOtherSideWhereALaterCutPartedIt) {
  const std::vector<RestEdge> edges = {{{0, 0, 0}, {1, 0, 0}},
                                       {{1, 0, 0}, {0.3, 0, 0}},
                                       {{0.3, 0, 0}, {0, 0, 0}},
                                       {{1, 0, 0}, {2, 0, 0}},
                                       {{0, 0, 0}, {0.3, 0.1, 0}}};
  const auto others = other_sides(edges);
  ASSERT_TRUE(others[0] && others[1] && others[2]);
  EXPECT_EQ(others[0]->edge, 1u);
  EXPECT_NEAR(others[0]->share, 0.5 / 0.7, 1e-12);
  EXPECT_EQ(others[1]->edge, 0u);
  EXPECT_NEAR(others[1]->share, 0.65, 1e-12);
  EXPECT_EQ(others[2]->edge, 0u);
  EXPECT_NEAR(others[2]->share, 0.15, 1e-12);
  EXPECT_FALSE(others[3]) << "goes on where the line ends";
  EXPECT_FALSE(others[4]) << "goes another way";
}

TEST(CutLines, AreDarkWhileTheCutIsClosedAndGoneWhenItGapes) {
  EXPECT_EQ(lines_of(opened(), opened()), 2u);
  EXPECT_EQ(lines_of(opened(), opened(0.001)), 2u) << "a pixel and a half";
  EXPECT_EQ(lines_of(opened(), opened(0.01)), 0u);
}

/// The strip whose one side a later cut has parted at `at` of the way.
TriangleMesh parted_again(double gap, double at) {
  TriangleMesh out = opened(gap);
  const auto m = static_cast<std::uint32_t>(out.positions.size());
  out.positions.push_back((1 - at) * out.positions[0] + at * out.positions[1]);
  out.triangles[1] = {m, 9, 1};
  out.triangles[4] = {m, 1, 3};
  for (const auto& t : {std::array<std::uint32_t, 3>{0, 9, m}, {0, m, 3}}) {
    out.triangles.push_back(t);
    out.inner.push_back(t[1] == m ? 1 : 0);
  }
  return out;
}

TEST(CutLines, AreGoneWhereItGapesAlsoBesideALaterCut) {
  const SoftReplica closed = replica_of(parted_again(0, 0.3), parted_again(0, 0.3));
  const SoftReplica gaping = replica_of(parted_again(0, 0.3), parted_again(0.01, 0.3));
  for (const SoftReplica* soft : {&closed, &gaping}) {
    const DrawMesh mesh = drawn(*soft);
    CutLines lines;
    lines.begin();
    lines.put(0, *soft, mesh, {});
    DrawList list = seen_from_above();
    lines.add(list);
    EXPECT_EQ(list.lines.size(), soft == &closed ? 3u : 0u);
  }
}

TEST(CutLines, OfAPieceThatIsHiddenAreNone) {
  TriangleMesh stays = opened();
  stays.triangles = {stays.triangles[0], stays.triangles[1], stays.triangles[4], stays.triangles[5]};
  stays.inner = {0, 0, 1, 1};
  EXPECT_EQ(lines_of(stays, opened()), 0u) << "one looks at the cut's face";
}

TEST(CutLines, OfASheetAreOfItsCutsNotItsBorder) {
  EXPECT_EQ(lines_of(parted_sheet(), parted_sheet()), 2u);
  TriangleMesh whole = parted_sheet();
  whole.triangles.resize(2);
  EXPECT_EQ(lines_of(whole, whole), 0u);
}

/// As sheets are drawn: front and back, of vertices of their own at the same places.
TriangleMesh with_back(TriangleMesh sheet) {
  const auto vertices = static_cast<std::uint32_t>(sheet.positions.size());
  const std::size_t triangles = sheet.triangles.size();
  for (std::uint32_t v = 0; v < vertices; ++v) sheet.positions.push_back(Vec3(sheet.positions[v]));
  for (std::size_t t = 0; t < triangles; ++t) {
    const auto [a, b, c] = sheet.triangles[t];
    sheet.triangles.push_back({a + vertices, c + vertices, b + vertices});
  }
  return sheet;
}

TEST(CutLines, OfASheetWithFrontAndBackAreOfItsCutsNotItsBorder) {
  EXPECT_EQ(cut_rims(with_back(parted_sheet())).size(), cut_rims(parted_sheet()).size());
  EXPECT_EQ(lines_of(with_back(parted_sheet()), with_back(parted_sheet())), 2u);
  TriangleMesh gaping = opened(0.01);
  gaping.triangles.resize(4);
  gaping.inner.clear();
  EXPECT_EQ(lines_of(with_back(parted_sheet()), with_back(gaping)), 0u) << "neither the cut nor the border";
}

TEST(CutLines, HaveTheirOtherSideOnAPieceThatCameOff) {
  TriangleMesh stays = opened(), piece = opened();
  stays.triangles = {stays.triangles[0], stays.triangles[1], stays.triangles[4], stays.triangles[5]};
  piece.triangles = {piece.triangles[2], piece.triangles[3], piece.triangles[6], piece.triangles[7]};
  stays.inner = piece.inner = {0, 0, 1, 1};
  const SoftReplica a = replica_of(stays, opened());
  const DrawMesh mesh_a = drawn(a);
  for (const double gap : {0.0, 0.02}) {
    const SoftReplica b = replica_of(piece, opened(gap));
    const DrawMesh mesh_b = drawn(b);
    CutLines lines;
    lines.begin();
    lines.put(0, a, mesh_a, {});
    lines.put(1, b, mesh_b, {});
    DrawList list = seen_from_above();
    lines.add(list);
    EXPECT_EQ(list.lines.size(), gap == 0 ? 2u : 0u);
  }
}

TEST(StrokeFigures, AreToldInMillimetres) {
  EXPECT_EQ(in_words({.length = 0.0632, .depth = 0.0118}), "63 mm long, 12 mm deep");
  EXPECT_EQ(in_words({.length = 0.0632}), "63 mm long") << "a sheet";
  EXPECT_EQ(in_words({.length = 0.2, .depth = 0.03, .through = true}),
            "200 mm long, through the full thickness");
  EXPECT_EQ(depth_in_words(0.012), "set to 12 mm");
}

TEST(BladeFrame, IsOfTheLongestEdgeAndLooksAwayFromTheMiddle) {
  RigidReplica scalpel;
  scalpel.mesh.positions = {{-0.005, -0.002, -0.1}, {0.005, 0.002, 0.06}};
  EXPECT_FALSE(blade_frame(scalpel));
  scalpel.edges = {{{-0.0035, 0, -0.1}, {0.0035, 0, -0.1}}, {{-0.0035, 0, -0.1}, {-0.0035, 0, -0.06}}};
  const auto blade = blade_frame(scalpel);
  ASSERT_TRUE(blade);
  EXPECT_NEAR(blade->length, 0.04, 1e-12);
  EXPECT_LT((blade->tip - Vec3(-0.0035, 0, -0.1)).norm(), 1e-12);
  EXPECT_LT((blade->along + Vec3::UnitZ()).norm(), 1e-12);
  EXPECT_LT((blade->ahead + Vec3::UnitX()).norm(), 1e-12);
  const Pose pose{{1, 2, 3}, Quat(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()))};
  EXPECT_LT(((pose * *blade).tip - pose * blade->tip).norm(), 1e-12);
}

}  // namespace
}  // namespace prosector
