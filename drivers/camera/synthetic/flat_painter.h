#pragma once
// Draws the flat things of a synthetic scene by exact rays.

#include <functional>
#include <memory>
#include <vector>

#include "common/math.h"
#include "drivers/camera/synthetic/ray_grid.h"
#include "drivers/camera/synthetic/texture.h"

namespace prosector {

/// A rectangle in the plane z = 0 of its own frame; its front looks along z.
struct FlatThing {
  std::size_t carrier = 0;       // what moves it
  Pose pose;                     // in the carrier's frame
  double width = 0, height = 0;  // m
  std::shared_ptr<const Texture> texture;
  bool both_sides = false;  // else it can't be seen from behind
};

/// Returns the pose of each carrier in the camera's frame at a moment, s.
using CarrierPoses = std::function<std::vector<Pose>(double seconds)>;

/// One row of pixels: each ray's light, and how far it went (m along z).
struct RayRow {
  std::vector<Rgb> light;
  std::vector<float> depth;
};

/// One lamp, far away, and what comes from everywhere.
struct Lamp {
  Vec3 towards = Vec3(0, 0, -1);  // unit, the camera's frame
  double ambient = 0.5;           // share of the light that has no direction
};

class FlatPainter {
 public:
  /// Makes ready for one picture. What is drawn later hides what lies in the same plane. `things` and `grid`
  /// must outlive it.
  FlatPainter(const RayGrid& grid, const std::vector<FlatThing>& things, CarrierPoses carriers,
              const Exposure& exposure, const Lamp& lamp);

  /// Draws one row over what is there.
  void draw(int y, RayRow& row) const;

 private:
  /// What maps a direction to the thing's plane at one moment.
  using Map = Eigen::Matrix3f;
  struct Shown {
    const FlatThing* thing;
    int left, right, top, bottom;  // pixels, the last ones included
    float lit;
    std::size_t level;      // of its texture
    std::vector<Map> maps;  // ray by ray, where the shutter doesn't roll
  };

  void show(const FlatThing& thing, const Lamp& lamp);
  Map map_at(const FlatThing& thing, double seconds) const;

  const RayGrid& grid_;
  CarrierPoses carriers_;
  Exposure exposure_;
  std::vector<Shown> shown_;
};

}  // namespace prosector
