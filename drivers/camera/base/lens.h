#pragma once
// Camera model: a pinhole with the distortion of Brown (1966, 1971), in OpenCV's convention.
//
// Camera frame: x right, y down, z forward; m. Pixels: x right, y down, with (0, 0) at the centre of the
// first pixel. With a = x/z, b = y/z, r² = a² + b²:
//   a' = a·(1 + k1·r² + k2·r⁴ + k3·r⁶) + 2·p1·a·b + p2·(r² + 2a²),
//   b' = b·(1 + k1·r² + k2·r⁴ + k3·r⁶) + 2·p2·a·b + p1·(r² + 2b²),
//   pixel = (fx·a' + cx, fy·b' + cy).

#include <array>
#include <optional>

#include "common/math.h"

namespace prosector {

using Vec2 = Eigen::Vector2d;

struct Lens {
  int width = 640, height = 480;  // size of the images, pixels
  double fx = 600, fy = 600;      // focal lengths, pixels
  double cx = 319.5, cy = 239.5;  // principal point, pixels
  double k1 = 0, k2 = 0, p1 = 0, p2 = 0, k3 = 0;

  /// Applies the lens distortion to a direction (a, b) = (x/z, y/z) in the camera frame. Returns the
  /// distorted direction.
  Vec2 bend(const Vec2& direction) const;
  /// Returns the derivative of bend(), the distorted direction (a', b'), with respect to the undistorted
  /// direction (a, b).
  Eigen::Matrix2d distortion_jacobian(const Vec2& direction) const;
  /// Removes the lens distortion from a direction: computes the inverse of bend() by Newton's method. The
  /// result is exact to 1e-12 where the distortion is invertible.
  Vec2 straighten(const Vec2& bent) const;
  /// Returns the pixel at which a point in the camera frame (x right, y down, z forward) appears. The point
  /// must have z > 0.
  Vec2 project(const Vec3& point) const;
  /// Returns the derivative of project(), the pixel of a point, with respect to the point's coordinates in
  /// the camera frame, pixels/m.
  Eigen::Matrix<double, 2, 3> projection_jacobian(const Vec3& point) const;
  /// Returns the direction (a, b, 1) of a pixel's line of sight in the camera frame, without distortion.
  Vec3 ray(const Vec2& pixel) const;
  bool sees(const Vec2& pixel) const {
    return pixel.x() >= -0.5 && pixel.y() >= -0.5 && pixel.x() < width - 0.5 && pixel.y() < height - 0.5;
  }
  /// Returns a copy of this lens without distortion, with the same focal lengths and principal point.
  Lens pinhole() const;
  /// Returns the pixel at which a camera with the same focal lengths and no distortion would image the line
  /// of sight of `pixel`.
  Vec2 undistorted_pixel(const Vec2& pixel) const;
  /// Returns the lens parameters for the same camera's images scaled to another size in pixels.
  Lens scaled(int to_width, int to_height) const;
  bool operator==(const Lens&) const = default;
};

}  // namespace prosector
