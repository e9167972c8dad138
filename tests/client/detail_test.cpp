// Levels of detail: what they promise of the surface, when they are chosen, and what pictures show of them.

#include "client/view/detail.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <map>
#include <thread>

#include "client/view/level_of_detail.h"
#include "client/view/normals.h"
#include "client/view/scene_view.h"
#include "tests/client/picture.h"

namespace prosector {
namespace {

using namespace test;

/// A ball with bumps, some 0.2 m wide, of as many triangles as a ball has.
std::shared_ptr<DrawMesh> bumpy_ball(std::uint64_t id) {
  auto mesh = sphere_mesh(0.1, id);
  for (auto& x : mesh->positions)
    x *= 1 + 0.08F * std::sin(40 * x.x()) * std::sin(35 * x.y() + 1) * std::sin(45 * x.z());
  smooth_normals(mesh->positions, mesh->triangles, mesh->normals);
  mesh->rest_positions = mesh->positions;
  return mesh;
}

double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (p - a - t * (b - a)).norm();
}

double distance_to_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 n = (b - a).cross(c - a);
  const auto beyond = [&](const Vec3& from, const Vec3& to) { return n.cross(to - from).dot(p - from) < 0; };
  if (!beyond(a, b) && !beyond(b, c) && !beyond(c, a)) return std::abs((p - a).dot(n.normalized()));
  return std::min({distance_to_segment(p, a, b), distance_to_segment(p, b, c), distance_to_segment(p, c, a)});
}

double farthest_vertex(const DrawMesh& mesh, const Triangles& triangles) {
  double farthest = 0;
  for (const auto& x : mesh.positions) {
    double nearest = 1e9;
    for (const auto& [a, b, c] : triangles)
      nearest = std::min(
          nearest, distance_to_triangle(x.cast<double>(), mesh.positions[a].cast<double>(),
                                        mesh.positions[b].cast<double>(), mesh.positions[c].cast<double>()));
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

constexpr double any = 1e9;  // m: no error is too large to be measured

TEST(Detail, EachLevelHasHalfTheTrianglesAndIsClosed) {
  const auto mesh = bumpy_ball(1);
  const Detail detail = make_detail(mesh->positions, mesh->triangles);
  ASSERT_GE(detail.coarser.size(), 3u);
  std::size_t before = mesh->triangles.size();
  for (const CoarserList& list : detail.coarser) {
    EXPECT_LE(list.triangles.size(), before / 2);
    EXPECT_GE(list.triangles.size(), before / 2 - 2);
    before = list.triangles.size();
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> ways;
    for (const auto& t : list.triangles)
      for (std::size_t k = 0; k < 3; ++k) ++ways[{t[k], t[(k + 1) % 3]}];
    for (const auto& [edge, count] : ways) {
      EXPECT_EQ(count, 1);
      EXPECT_EQ(ways.count({edge.second, edge.first}), 1u);
    }
  }
}

TEST(Detail, IsTheSameTwice) {
  const auto mesh = bumpy_ball(1);
  const Detail a = make_detail(mesh->positions, mesh->triangles);
  const Detail b = make_detail(mesh->positions, mesh->triangles);
  ASSERT_EQ(a.coarser.size(), b.coarser.size());
  for (std::size_t k = 0; k < a.coarser.size(); ++k)
    EXPECT_EQ(a.coarser[k].triangles, b.coarser[k].triangles);
}

// Also of a shape that it was not made for: all vertices sheared and bent.
TEST(Detail, NoVertexIsFartherFromTheCoarserSurfaceThanItSays) {
  const auto mesh = bumpy_ball(1);
  const Detail detail = make_detail(mesh->positions, mesh->triangles);
  for (const bool bent : {false, true}) {
    if (bent)
      for (auto& x : mesh->positions)
        x += Eigen::Vector3f(0.5F * x.y(), 4 * x.x() * x.x(), 0.3F * std::sin(20 * x.x()) * x.z());
    smooth_normals(mesh->positions, mesh->triangles, mesh->normals);
    double before = 0;
    for (const std::size_t level : {1U, 3U}) {
      const CoarserList& list = detail.coarser[level];
      const double error = error_of(list, mesh->positions, mesh->normals, any);
      EXPECT_LE(farthest_vertex(*mesh, list.triangles), error + 1e-6);
      EXPECT_LT(error, 0.02);
      EXPECT_GT(error, before);
      before = error;
    }
  }
}

TEST(Detail, AFlatSheetsLevelsAreOffWhenItFolds) {
  constexpr std::uint32_t n = 24;
  DrawMesh sheet;
  for (std::uint32_t i = 0; i <= n; ++i)
    for (std::uint32_t k = 0; k <= n; ++k)
      sheet.positions.emplace_back(0.01F * static_cast<float>(i), 0, 0.01F * static_cast<float>(k));
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t k = 0; k < n; ++k) {
      const std::uint32_t a = i * (n + 1) + k;
      sheet.triangles.push_back({a, a + 1, a + n + 1});
      sheet.triangles.push_back({a + 1, a + n + 2, a + n + 1});
    }
  const Detail detail = make_detail(sheet.positions, sheet.triangles);
  ASSERT_GE(detail.coarser.size(), 2u);
  smooth_normals(sheet.positions, sheet.triangles, sheet.normals);
  EXPECT_LT(error_of(detail.coarser[1], sheet.positions, sheet.normals, any), 1e-6);
  for (auto& x : sheet.positions)
    x = {0.04F * std::sin(x.x() / 0.04F), 0.04F * std::cos(x.x() / 0.04F), x.z()};
  smooth_normals(sheet.positions, sheet.triangles, sheet.normals);
  EXPECT_GT(error_of(detail.coarser[1], sheet.positions, sheet.normals, any), 2e-4);
}

DrawList ball_list(const std::shared_ptr<DrawMesh>& mesh, double distance) {
  DrawList list;
  list.cameras = {straight_camera({0, 0, distance}, 320, 240)};
  list.items = {{.mesh = mesh, .pose = {}, .appearance = {{0.6, 0.35, 0.3}, 0.4, 0.6, Surface::tissue}}};
  list.lights = {lamp({0.6, 1, 0.8}, Vec3::Zero())};
  return list;
}

constexpr double usual = quality_levels[1].detail;

TEST(LevelOfDetail, FewerTrianglesAreDrawnFartherAway) {
  DrawList list = ball_list(bumpy_ball(1), 0.15);
  add_detail(list);
  LevelOfDetail level_of_detail;
  level_of_detail.choose(list, usual);
  const std::size_t full = list.items[0].mesh->triangles.size();
  EXPECT_EQ(triangles_of(list.items[0]).size(), full);
  std::size_t before = full;
  for (const double distance : {1.0, 2.0, 4.0, 8.0, 16.0}) {
    list.cameras[0].pose.p.z() = distance;
    level_of_detail.choose(list, usual);
    EXPECT_LE(triangles_of(list.items[0]).size(), before);
    before = triangles_of(list.items[0]).size();
  }
  EXPECT_LE(before, full / 16);
  level_of_detail.choose(list, 0);
  EXPECT_EQ(triangles_of(list.items[0]).size(), full);
}

TEST(LevelOfDetail, ASmallStepOfTheEyeBackAndForthChangesNothing) {
  DrawList list = ball_list(bumpy_ball(1), 0.5);
  add_detail(list);
  LevelOfDetail level_of_detail;
  int switches = 0;
  for (double distance = 0.5; distance < 6; distance *= 1.01) {
    std::size_t before = 0;
    for (int step = 0; step < 4; ++step) {
      list.cameras[0].pose.p.z() = distance * (step % 2 == 0 ? 1.05 : 1);
      level_of_detail.choose(list, usual);
      if (step > 0 && list.items[0].level != before) ++switches;
      before = list.items[0].level;
    }
  }
  EXPECT_EQ(switches, 0);
  EXPECT_GT(list.items[0].level, 1u) << "the way was too short to tell";
}

TEST(LevelOfDetail, TheNearestEyeOfAllDecides) {
  DrawList list = ball_list(bumpy_ball(1), 8);
  add_detail(list);
  LevelOfDetail().choose(list, usual);
  EXPECT_GT(list.items[0].level, 0u);
  list.cameras.push_back(straight_camera({0, 0, 0.15}, 80, 60));
  list.cameras.back().inset = true;
  LevelOfDetail().choose(list, usual);
  EXPECT_EQ(list.items[0].level, 0u);
}

/// Chooses as a client does while it runs.
void choose_for_a_while(LevelOfDetail& level_of_detail, DrawList& list) {
  for (int picture = 0; picture < 500 && list.items[0].level == 0; ++picture) {
    level_of_detail.choose(list, usual);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

TEST(LevelOfDetail, LevelsComeInTheBackgroundAndAnewAfterACut) {
  const auto mesh = bumpy_ball(1);
  DrawList list = ball_list(mesh, 6);
  LevelOfDetail level_of_detail;
  level_of_detail.choose(list, usual);
  EXPECT_EQ(list.items[0].level, 0u) << "nothing waits for them";
  choose_for_a_while(level_of_detail, list);
  EXPECT_GT(list.items[0].level, 0u);
  mesh->triangles.resize(mesh->triangles.size() * 3 / 4);
  ++mesh->revision;
  list.items[0].detail = nullptr;  // as a view's items are, made anew for each picture
  level_of_detail.choose(list, usual);
  EXPECT_EQ(triangles_of(list.items[0]), mesh->triangles);
  choose_for_a_while(level_of_detail, list);
  ASSERT_GT(list.items[0].level, 0u);
  EXPECT_LE(triangles_of(list.items[0]).size(), mesh->triangles.size() / 2);
}

struct Difference {
  double mean = 0;   // of 255
  double clear = 0;  // share of the bytes that differ by more than 24
};
Difference between(const Image& a, const Image& b) {
  Difference out;
  for (std::size_t k = 0; k < a.rgb.size(); ++k) {
    const int d = std::abs(int{a.rgb[k]} - int{b.rgb[k]});
    out.mean += d;
    out.clear += d > 24 ? 1 : 0;
  }
  out.mean /= static_cast<double>(a.rgb.size());
  out.clear /= static_cast<double>(a.rgb.size());
  return out;
}

/// Draws the ball from one distance after the other, with levels of detail or in full.
class Zoom {
 public:
  explicit Zoom(double pixels) : pixels_(pixels) { add_detail(list_); }
  Image at(double distance) {
    list_.cameras[0].pose.p.z() = distance;
    level_of_detail_.choose(list_, pixels_);
    renderer_.draw(list_);
    return renderer_.read_pixels();
  }
  std::size_t level() const { return list_.items[0].level; }

 private:
  double pixels_;
  DrawList list_ = ball_list(bumpy_ball(1), 1);
  LevelOfDetail level_of_detail_;
  std::unique_ptr<GlContext> context_ = make_offscreen_context(320, 240);
  Renderer renderer_{*context_, default_shader_dir()};
};

// What differs are pixels of the outline.
TEST(LevelOfDetail, PicturesAreNearlyThoseOfAllTriangles) {
  Zoom full(0), coarse(usual);
  for (const double distance : {0.6, 1.2, 2.4, 4.8}) {
    const Difference d = between(full.at(distance), coarse.at(distance));
    EXPECT_LT(d.mean, 0.05) << distance;
    EXPECT_LT(d.clear, 2e-4) << distance;
  }
  EXPECT_EQ(full.level(), 0u);
  EXPECT_GE(coarse.level(), 3u);
}

// The step from one picture to the next is hardly larger where a level changes.
TEST(LevelOfDetail, NothingPopsOnTheWay) {
  Zoom full(0), coarse(usual);
  Image full_before = full.at(0.4), coarse_before = coarse.at(0.4);
  std::size_t level_before = coarse.level();
  int changes = 0;
  for (double distance = 0.4; distance < 4; distance *= 1.02) {
    const Image f = full.at(distance), c = coarse.at(distance);
    if (coarse.level() != level_before) {
      ++changes;
      EXPECT_LT(between(c, coarse_before).mean, 1.3 * between(f, full_before).mean) << distance;
    }
    level_before = coarse.level();
    full_before = f;
    coarse_before = c;
  }
  EXPECT_GE(changes, 2);
}

}  // namespace
}  // namespace prosector
