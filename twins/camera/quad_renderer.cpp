#include "twins/camera/quad_renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace prosector {
namespace {

constexpr double near_plane = 0.01;  // m; an object with a nearer corner may cover the whole image
constexpr float same_plane =
    1e-5f;                 // relative difference in depth; within it, the later object covers the earlier one
constexpr int margin = 2;  // pixels, around the projected corners
constexpr int samples_a_side = 8;  // samples per side of the outline, which the lens bends

}  // namespace

QuadRenderer::QuadRenderer(const RayGrid& grid, const std::vector<TexturedQuad>& things,
                           CarrierPoses carriers, const Exposure& exposure, const Lamp& lamp)
    : grid_(grid), carriers_(std::move(carriers)), exposure_(exposure) {
  for (const TexturedQuad& thing : things) show(thing, lamp);
  if (exposure.readout != 0) return;
  for (std::size_t ray = 0; ray < grid_.rays(); ++ray)
    for (Shown& shown : shown_) shown.maps.push_back(map_at(*shown.thing, grid_.moment(exposure_, 0, ray)));
}

void QuadRenderer::show(const TexturedQuad& thing, const Lamp& lamp) {
  const Lens& lens = grid_.lens();
  double left = lens.width, right = -1, top = lens.height, bottom = -1;
  const double half = exposure_.length / 2 + std::abs(exposure_.readout) / 2;
  for (const double when : {-half, 0.0, half}) {
    const Pose camera_thing = carriers_(exposure_.middle + when)[thing.carrier] * thing.pose;
    for (int side = 0; side < 4; ++side)
      for (int k = 0; k < samples_a_side; ++k) {
        const double along = static_cast<double>(k) / samples_a_side - 0.5;
        const std::array<std::array<double, 2>, 4> at = {
            {{along, -0.5}, {0.5, along}, {-along, 0.5}, {-0.5, -along}}};
        const auto& [u, v] = at[static_cast<std::size_t>(side)];
        const Vec3 point = camera_thing * Vec3(u * thing.width, v * thing.height, 0);
        if (point.z() < near_plane) {
          left = top = 0;
          right = lens.width;
          bottom = lens.height;
          continue;
        }
        // Far outside the image the distortion polynomial may fold back, so the undistorted projection is
        // used.
        Vec2 direction(point.x() / point.z(), point.y() / point.z());
        const Vec2 pixel = direction.norm() < 1.5
                               ? lens.project(point)
                               : Vec2(lens.fx * direction.x() + lens.cx, lens.fy * direction.y() + lens.cy);
        left = std::min(left, pixel.x());
        right = std::max(right, pixel.x());
        top = std::min(top, pixel.y());
        bottom = std::max(bottom, pixel.y());
      }
  }
  const auto bounded = [](double at, int last) { return static_cast<int>(std::clamp(at, -1.0, last + 1.0)); };
  Shown shown{&thing,
              std::max(0, bounded(left, lens.width) - margin),
              std::min(lens.width - 1, bounded(right, lens.width) + margin),
              std::max(0, bounded(top, lens.height) - margin),
              std::min(lens.height - 1, bounded(bottom, lens.height) + margin),
              1,
              0,
              {}};
  if (shown.left > shown.right || shown.top > shown.bottom) return;
  const Pose middle = carriers_(exposure_.middle)[thing.carrier] * thing.pose;
  const Vec3 normal = middle.q * Vec3::UnitZ();
  const double facing = normal.dot(lamp.towards);
  const double met = thing.both_sides ? std::abs(facing) : std::max(0.0, facing);
  shown.lit = static_cast<float>(lamp.ambient + (1 - lamp.ambient) * met);
  const double metres = std::max(near_plane, middle.p.norm()) / lens.fx;  // size of a pixel at the object
  shown.level = thing.texture->level(metres / (thing.width / thing.texture->width()));
  shown_.push_back(std::move(shown));
}

QuadRenderer::Map QuadRenderer::map_at(const TexturedQuad& thing, double seconds) const {
  const Pose camera_thing = carriers_(seconds)[thing.carrier] * thing.pose;
  const Mat3 turn = camera_thing.q.toRotationMatrix();
  // Objects seen edge-on or from behind get a map that hits nothing.
  if (!thing.both_sides && (turn.col(2).dot(camera_thing.p) >= 0)) return Map::Zero();
  Mat3 plane;
  plane << turn.col(0) * thing.width, turn.col(1) * thing.height, camera_thing.p;
  if (std::abs(plane.determinant()) < std::numeric_limits<double>::min()) return Map::Zero();
  return plane.inverse().cast<float>();
}

void QuadRenderer::draw(int y, RayRow& row) const {
  const std::size_t rays = grid_.rays();
  for (const Shown& shown : shown_) {
    if (y < shown.top || y > shown.bottom) continue;
    for (std::size_t ray = 0; ray < rays; ++ray) {
      const Map map =
          shown.maps.empty() ? map_at(*shown.thing, grid_.moment(exposure_, y, ray)) : shown.maps[ray];
      for (int x = shown.left; x <= shown.right; ++x) {
        const Eigen::Vector2f d = grid_.direction(x, y, ray);
        const float w = map(2, 0) * d.x() + map(2, 1) * d.y() + map(2, 2);  // inverse of the depth
        if (w <= 0) continue;
        const float u = (map(0, 0) * d.x() + map(0, 1) * d.y() + map(0, 2)) / w;
        const float v = (map(1, 0) * d.x() + map(1, 1) * d.y() + map(1, 2)) / w;
        if (!(std::abs(u) <= 0.5f && std::abs(v) <= 0.5f)) continue;
        const std::size_t at = static_cast<std::size_t>(x) * rays + ray;
        const float depth = 1 / w;
        if (depth > row.depth[at] * (1 + same_plane)) continue;
        row.depth[at] = depth;
        Rgb light = shown.thing->texture->at(u + 0.5f, 0.5f - v, shown.level);
        for (float& c : light) c *= shown.lit;
        row.light[at] = light;
      }
    }
  }
}

}  // namespace prosector
