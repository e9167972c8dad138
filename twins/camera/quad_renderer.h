#pragma once
// Draws the flat objects of a synthetic scene by exact ray casting.

#include <functional>
#include <memory>
#include <vector>

#include "common/math.h"
#include "twins/camera/ray_grid.h"
#include "twins/camera/texture.h"

namespace prosector {

/// A textured rectangle of a synthetic scene in the plane z = 0 of its frame; its front faces +z. It moves
/// with a carrier, a frame with a given or scripted motion.
struct TexturedQuad {
  std::size_t carrier = 0;       // index of the carrier that moves the rectangle
  Pose pose;                     // in the carrier's frame
  double width = 0, height = 0;  // m
  std::shared_ptr<const Texture> texture;
  bool both_sides = false;  // false: invisible from behind
};

/// Function that returns the pose of each carrier (moving frame) of a synthetic scene in the camera's frame
/// at a time, s.
using CarrierPoses = std::function<std::vector<Pose>(double seconds)>;

/// One row of a synthetic image while it is drawn: light and depth (m along z) of each ray, with several rays
/// per pixel.
struct RayRow {
  std::vector<Rgb> light;
  std::vector<float> depth;
};

/// Lighting of a synthetic scene: a distant lamp and ambient light.
struct Lamp {
  Vec3 towards = Vec3(0, 0, -1);  // unit vector to the lamp, camera's frame
  double ambient = 0.5;           // ambient share of the light, 0 to 1
};

class QuadRenderer {
 public:
  /// Prepares the drawing of rectangles into one image. `carriers` returns the poses of the frames that move
  /// them. Among rectangles in one plane, a later one covers earlier ones. `things` and `grid` must outlive
  /// the renderer.
  QuadRenderer(const RayGrid& grid, const std::vector<TexturedQuad>& things, CarrierPoses carriers,
               const Exposure& exposure, const Lamp& lamp);

  /// Draws row `y` of the image into `row`, where the rectangles are nearer than the row's present content.
  void draw(int y, RayRow& row) const;

 private:
  /// Homography from a ray's direction (x/z, y/z) to coordinates in a rectangle's plane at one time.
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
