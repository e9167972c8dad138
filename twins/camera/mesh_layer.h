#pragma once
// Shaded triangles rendered with a z-buffer for a synthetic camera: light and depth over a rectangle of ray
// directions.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/math.h"
#include "twins/camera/quad_renderer.h"

namespace prosector {

/// A triangle mesh to be drawn, with normals and a reflectance per vertex.
struct ShadedMesh {
  std::span<const Eigen::Vector3f> positions, normals;
  std::span<const std::array<std::uint32_t, 3>> triangles;  // counter-clockwise as seen from outside
  std::span<const Rgb> paint;                               // one per vertex
};

class MeshDepthBuffer {
 public:
  /// Creates a buffer of width × height cells for the rays with directions (x/z, y/z) from `low` to `high` in
  /// the camera's frame.
  MeshDepthBuffer(int width, int height, const Eigen::Vector2d& low, const Eigen::Vector2d& high);
  /// Creates a buffer that covers the lens' whole field of view, with cells finer than its pixels.
  explicit MeshDepthBuffer(const Lens& lens);

  void clear();
  /// Draws a mesh into the buffer, where it is nearer than the present content. `camera_mesh` is its pose in
  /// the camera's frame (x right, y down, z forward). Triangles nearer than 2 cm are left out.
  void draw(const ShadedMesh& mesh, const Pose& camera_mesh, const Lamp& lamp);

  struct Hit {
    Rgb light{};
    float depth = 0;  // m along z; infinite: no surface
  };
  /// Returns the light and depth in the buffer's cell that contains the ray with direction (x/z, y/z). The
  /// depth is infinite if no surface was drawn there.
  Hit at(const Eigen::Vector2f& direction) const;

 private:
  struct Corner {
    Eigen::Vector3f at;  // position in cells, and 1/z
    Rgb light;
  };
  void fill(const std::array<const Corner*, 3>& corners);

  int width_, height_;
  Eigen::Vector2f low_, cells_;  // lower corner, as a direction; cells per unit of direction
  std::vector<Hit> hits_;
};

}  // namespace prosector
