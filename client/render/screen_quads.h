#pragma once
// Lines of a width in pixels as triangles in normalised device coordinates. No GL.

#include <vector>

#include "common/math.h"

namespace prosector {

struct ScreenVertex {
  Eigen::Vector3f at;     // normalised device coordinates
  Eigen::Vector3f color;  // linear RGB
  Eigen::Vector4f pen;    // pixels: along the line from its start, across it; its length, half its width
};

struct Viewport {
  double width, height;  // pixels
};

/// Adds the two triangles of the line from a to b (clip coordinates), `width` pixels wide, with square ends.
/// A `margin` (pixels) around it is for a shader that fades the line out. What lies behind the eye is cut
/// off.
void add_line(std::vector<ScreenVertex>& out, Eigen::Vector4d a, Eigen::Vector4d b, const Vec3& color,
              double width, const Viewport& viewport, double margin = 0);

}  // namespace prosector
