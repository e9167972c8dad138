#pragma once
// What a camera does to directions: a pinhole with the distortion of Brown (1966, 1971), in OpenCV's terms.
//
// A camera's frame: x right, y down, z ahead; m. Pixels: x right, y down, the centre of the first one is (0,
// 0). With a = x/z, b = y/z, r² = a² + b²:
//   a' = a·(1 + k1·r² + k2·r⁴ + k3·r⁶) + 2·p1·a·b + p2·(r² + 2a²), b' the same with p1 (r² + 2b²) + 2·p2·a·b,
//   pixel = (fx·a' + cx, fy·b' + cy).

#include <array>
#include <optional>

#include "common/math.h"

namespace prosector {

using Vec2 = Eigen::Vector2d;

struct Lens {
  int width = 640, height = 480;  // of its pictures, pixels
  double fx = 600, fy = 600;      // focal lengths, pixels
  double cx = 319.5, cy = 239.5;  // principal point, pixels
  double k1 = 0, k2 = 0, p1 = 0, p2 = 0, k3 = 0;

  /// Maps a direction at distance 1 (a, b) to where the lens bends it.
  Vec2 bend(const Vec2& direction) const;
  /// Returns how bend() moves by the direction.
  Eigen::Matrix2d bend_slope(const Vec2& direction) const;
  /// Finds what bend() maps there, by Newton's method; exact to 1e-12 where the lens doesn't fold.
  Vec2 straighten(const Vec2& bent) const;
  /// Returns the pixel of a point in the camera's frame; it must lie ahead.
  Vec2 project(const Vec3& point) const;
  /// Returns how that pixel moves by the point.
  Eigen::Matrix<double, 2, 3> pixel_slope(const Vec3& point) const;
  /// Returns the direction (a, b, 1) that a pixel looks into.
  Vec3 ray(const Vec2& pixel) const;
  bool sees(const Vec2& pixel) const {
    return pixel.x() >= -0.5 && pixel.y() >= -0.5 && pixel.x() < width - 0.5 && pixel.y() < height - 0.5;
  }
  /// Returns the same lens without distortion.
  Lens pinhole() const;
  /// Returns where pinhole() sees what a pixel shows.
  Vec2 straight_pixel(const Vec2& pixel) const;
  /// Returns the same lens for pictures of another size.
  Lens scaled(int to_width, int to_height) const;
  bool operator==(const Lens&) const = default;
};

}  // namespace prosector
