// What other things hide is left out, and no picture tells.

#include <gtest/gtest.h>

#include <vector>

#include "client/view/camera.h"
#include "tests/client/picture.h"

namespace prosector {
namespace {

using namespace test;

DrawItem ball(double radius, const Vec3& at, std::uint64_t id, Surface surface = Surface::tissue) {
  return {.mesh = sphere_mesh(radius, id),
          .pose = {at, Quat::Identity()},
          .appearance = {{0.6, 0.35, 0.3}, 0.4, 0.6, surface}};
}

/// A thick slab across z, of one box.
DrawItem slab(double half_width, double half_height, double z, std::uint64_t id) {
  PartDesc part;
  part.shape = "box";
  part.size = {2 * half_width, 2 * half_height, 0.04};
  const TriangleMesh box = mesh_of(part);
  auto mesh = std::make_shared<DrawMesh>();
  mesh->id = id;
  for (const Vec3& x : box.positions) {
    mesh->positions.push_back(x.cast<float>());
    mesh->normals.push_back(x.normalized().cast<float>());
  }
  mesh->triangles = box.triangles;
  return {.mesh = mesh, .pose = {{0, 0, z}, Quat::Identity()}, .appearance = {{0.4, 0.5, 0.4}, 0.5, 0}};
}

/// A ball behind a slab, one that looks out above it, one before it, one in another, and a mirror that shows
/// no more than the room; the lamp stands behind it all, so that what is hidden casts shadows that are seen.
DrawList behind_a_slab() {
  DrawList list;
  list.items = {slab(0.4, 0.3, 0, 1),
                ball(0.15, {0, 0, -0.4}, 2),
                ball(0.12, {0.1, 0.3, -0.3}, 3),
                ball(0.08, {-0.1, 0, 0.3}, 4),
                ball(0.2, {1.2, 0, -0.2}, 5, Surface::metal),
                ball(0.1, {1.2, 0, -0.2}, 6),
                slab(3, 3, -2, 7)};
  list.lights = {lamp({0.1, 0.4, -1.6}, {0, -0.2, 0.4}), directional({0.2, -1, -0.4})};
  return list;
}

struct Drawn {
  Image image;
  std::size_t hidden;
};
/// The lists one after the other, each three times: what was seen is not asked about in every picture.
std::vector<Drawn> drawn(const std::vector<DrawList>& lists, RendererSettings settings, bool occlusion) {
  settings.occlusion = occlusion;
  const auto context = make_offscreen_context(320, 120);
  Renderer renderer(*context, default_shader_dir(), settings);
  std::vector<Drawn> out;
  for (const DrawList& list : lists) {
    for (int picture = 0; picture < 3; ++picture) renderer.draw(list);
    out.push_back({renderer.read_pixels(), renderer.hidden()});
  }
  return out;
}

/// How many things were hidden, in all pictures together.
std::size_t hidden_in_same_pictures(const std::vector<DrawList>& lists, const RendererSettings& settings) {
  const std::vector<Drawn> with = drawn(lists, settings, true), without = drawn(lists, settings, false);
  std::size_t hidden = 0;
  for (std::size_t k = 0; k < lists.size(); ++k) {
    EXPECT_TRUE(with[k].image == without[k].image) << "picture " << k;
    EXPECT_EQ(without[k].hidden, 0u);
    hidden += with[k].hidden;
  }
  return hidden;
}

TEST(Occlusion, PicturesAreTheSameBytesFromEverywhere) {
  std::vector<DrawList> lists;
  for (const Vec3& eye : {Vec3(0, 0, 1.5), Vec3(0.9, 0.2, 1), Vec3(0, 1.2, 0.9), Vec3(-1.5, 0, -0.3),
                          Vec3(0, 0.05, -0.42), Vec3(1.2, 0, 0.02), Vec3(0, 0.31, 0.4)}) {
    lists.push_back(behind_a_slab());
    lists.back().cameras = {mono_camera(look_at(eye, {0.1, 0, -0.2}), 0.9, 320, 120)};
  }
  for (const QualityLevel& level : quality_levels)
    EXPECT_GE(hidden_in_same_pictures(lists, level.settings), 3u) << level.name;
}

TEST(Occlusion, InStereoAndInAnInsetToo) {
  DrawList list = behind_a_slab();
  for (const DrawCamera& eye : stereo_cameras(look_at({0, 0, 1.5}, {0, 0, 0}), StereoProfile(), 320, 120))
    list.cameras.push_back(eye);
  list.cameras.push_back(mono_camera(look_at({-1.5, 0, -0.3}, {0, 0, -0.3}), 0.9, 80, 60));
  list.cameras.back().inset = true;
  EXPECT_GE(hidden_in_same_pictures({list}, {}), 2u);
}

/// A ball comes out from behind the slab, step by step, and how much was hidden in each.
std::vector<Drawn> coming_out(bool occlusion) {
  DrawList list = behind_a_slab();
  list.cameras = {mono_camera(look_at({0, 0, 1.5}, {0, 0, 0}), 0.9, 160, 120)};
  RendererSettings settings;
  settings.occlusion = occlusion;
  const auto context = make_offscreen_context(160, 120);
  Renderer renderer(*context, default_shader_dir(), settings);
  std::vector<Drawn> out;
  for (double x = 0; x < 1; x += 0.05) {
    list.items[1].pose.p.x() = x;
    renderer.draw(list);
    out.push_back({renderer.read_pixels(), renderer.hidden()});
  }
  return out;
}

TEST(Occlusion, WhatComesOutIsSeenAtOnce) {
  const std::vector<Drawn> with = coming_out(true), without = coming_out(false);
  for (std::size_t step = 0; step < with.size(); ++step)
    EXPECT_TRUE(with[step].image == without[step].image) << step;
  EXPECT_GT(with.front().hidden, with.back().hidden);
}

}  // namespace
}  // namespace prosector
