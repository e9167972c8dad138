#pragma once
// Lines with a width in pixels, as triangles in normalised device coordinates. No GL.

#include <vector>

#include "common/math.h"

namespace prosector {

struct ScreenVertex {
  Eigen::Vector3f at;     // normalised device coordinates
  Eigen::Vector3f color;  // linear RGB
};

struct Viewport {
  double width, height;  // pixels
};

/// Returns the point (clip coordinates) moved slightly towards the eye, by about 1 mm at arm's length, so
/// that a line on a surface is not hidden by the surface.
inline Eigen::Vector4d in_front(Eigen::Vector4d clip) {
  constexpr double depth_bias = 4e-5;
  clip.z() -= depth_bias * clip.w();
  return clip;
}

/// Adds to `out` two triangles that form the line from a to b (clip coordinates), `width` pixels wide, with
/// square ends. The line is clipped at the near plane.
void add_line(std::vector<ScreenVertex>& out, Eigen::Vector4d a, Eigen::Vector4d b, const Vec3& color,
              double width, const Viewport& viewport);

}  // namespace prosector
