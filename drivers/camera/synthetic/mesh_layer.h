#pragma once
// Shaded triangles as a synthetic camera's rays meet them: light and depth over a rectangle of directions, by
// a z-buffer.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/math.h"
#include "drivers/camera/synthetic/flat_painter.h"

namespace prosector {

/// A surface with what its vertices give back of the light.
struct ShadedMesh {
  std::span<const Eigen::Vector3f> positions, normals;
  std::span<const std::array<std::uint32_t, 3>> triangles;  // counter-clockwise seen from outside
  std::span<const Rgb> paint;                               // of each vertex
};

class MeshLayer {
 public:
  /// Directions (a, b) at distance 1 from `low` to `high`, in so many cells.
  MeshLayer(int width, int height, const Eigen::Vector2d& low, const Eigen::Vector2d& high);
  /// Makes one of all that a lens sees, finer than its pixels.
  explicit MeshLayer(const Lens& lens);

  void clear();
  /// Draws a surface over what is there. The camera's frame is x right, y down, z ahead; what is nearer than
  /// 2 cm is left out.
  void draw(const ShadedMesh& mesh, const Pose& camera_mesh, const Lamp& lamp);

  struct Hit {
    Rgb light{};
    float depth = 0;  // m along z; infinite: nothing is there
  };
  /// Returns what a ray meets, at the nearest cell.
  Hit at(const Eigen::Vector2f& direction) const;

 private:
  struct Corner {
    Eigen::Vector3f at;  // cells, and 1/z
    Rgb light;
  };
  void fill(const std::array<const Corner*, 3>& corners);

  int width_, height_;
  Eigen::Vector2f low_, cells_;  // and cells a unit of direction
  std::vector<Hit> hits_;
};

}  // namespace prosector
