#pragma once
// Draws the flat objects of a synthetic scene by exact ray casting.

#include <functional>
#include <memory>
#include <vector>

#include "common/math.h"
#include "twins/camera/ray_grid.h"
#include "twins/camera/texture.h"

namespace prosector {

/// A rectangle in the plane z = 0 of its frame; its front faces +z.
struct TexturedQuad {
  std::size_t carrier = 0;       // index of the carrier that moves the rectangle
  Pose pose;                     // in the carrier's frame
  double width = 0, height = 0;  // m
  std::shared_ptr<const Texture> texture;
  bool both_sides = false;  // false: invisible from behind
};

/// Returns the pose of each carrier in the camera's frame at a time, s.
using CarrierPoses = std::function<std::vector<Pose>(double seconds)>;

/// One row of pixels: light and depth (m along z) of each ray.
struct RayRow {
  std::vector<Rgb> light;
  std::vector<float> depth;
};

/// A distant lamp, and ambient light.
struct Lamp {
  Vec3 towards = Vec3(0, 0, -1);  // unit vector to the lamp, camera's frame
  double ambient = 0.5;           // ambient share of the light, 0 to 1
};

class QuadRenderer {
 public:
  /// Prepares an image. Among objects in one plane, a later one covers earlier ones. `things` and `grid` must
  /// outlive the painter.
  QuadRenderer(const RayGrid& grid, const std::vector<TexturedQuad>& things, CarrierPoses carriers,
               const Exposure& exposure, const Lamp& lamp);

  /// Draws one row over its present content, where nearer.
  void draw(int y, RayRow& row) const;

 private:
  /// Homography from a ray's direction to the object's plane at one time.
  using Map = Eigen::Matrix3f;
  struct Shown {
    const TexturedQuad* thing;
    int left, right, top, bottom;  // bounding box in pixels, inclusive
    float lit;
    std::size_t level;      // of the texture
    std::vector<Map> maps;  // one per ray; empty with a rolling shutter
  };

  void show(const TexturedQuad& thing, const Lamp& lamp);
  Map map_at(const TexturedQuad& thing, double seconds) const;

  const RayGrid& grid_;
  CarrierPoses carriers_;
  Exposure exposure_;
  std::vector<Shown> shown_;
};

}  // namespace prosector
