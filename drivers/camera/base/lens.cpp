#include "drivers/camera/base/lens.h"

#include <cmath>

namespace prosector {
namespace {

constexpr int most_steps = 30;

struct Bent {
  Vec2 at;
  Eigen::Matrix2d slope;
};

Bent bent_with_slope(const Lens& lens, const Vec2& d) {
  const double a = d.x(), b = d.y(), r2 = a * a + b * b;
  const double radial = 1 + r2 * (lens.k1 + r2 * (lens.k2 + r2 * lens.k3));
  const double grows =
      lens.k1 + r2 * (2 * lens.k2 + 3 * r2 * lens.k3);  // derivative of `radial` with respect to r²
  Bent out;
  out.at = {a * radial + 2 * lens.p1 * a * b + lens.p2 * (r2 + 2 * a * a),
            b * radial + lens.p1 * (r2 + 2 * b * b) + 2 * lens.p2 * a * b};
  const double cross = 2 * a * b * grows + 2 * lens.p1 * a + 2 * lens.p2 * b;
  out.slope << radial + 2 * a * a * grows + 2 * lens.p1 * b + 6 * lens.p2 * a, cross, cross,
      radial + 2 * b * b * grows + 6 * lens.p1 * b + 2 * lens.p2 * a;
  return out;
}

}  // namespace

Vec2 Lens::bend(const Vec2& direction) const {
  return bent_with_slope(*this, direction).at;
}

Eigen::Matrix2d Lens::distortion_jacobian(const Vec2& direction) const {
  return bent_with_slope(*this, direction).slope;
}

Vec2 Lens::straighten(const Vec2& bent) const {
  Vec2 guess = bent;
  for (int step = 0; step < most_steps; ++step) {
    const Bent here = bent_with_slope(*this, guess);
    const Vec2 miss = bent - here.at;
    if (miss.squaredNorm() < 1e-28 || std::abs(here.slope.determinant()) < 1e-6) break;
    guess += here.slope.inverse() * miss;
  }
  return guess;
}

Vec2 Lens::project(const Vec3& point) const {
  const Vec2 bent = bend(Vec2(point.x() / point.z(), point.y() / point.z()));
  return {fx * bent.x() + cx, fy * bent.y() + cy};
}

Eigen::Matrix<double, 2, 3> Lens::projection_jacobian(const Vec3& p) const {
  Eigen::Matrix<double, 2, 3> by_point;
  by_point << 1 / p.z(), 0, -p.x() / (p.z() * p.z()), 0, 1 / p.z(), -p.y() / (p.z() * p.z());
  return Vec2(fx, fy).asDiagonal() * distortion_jacobian({p.x() / p.z(), p.y() / p.z()}) * by_point;
}

Vec3 Lens::ray(const Vec2& pixel) const {
  const Vec2 direction = straighten({(pixel.x() - cx) / fx, (pixel.y() - cy) / fy});
  return {direction.x(), direction.y(), 1};
}

Lens Lens::pinhole() const {
  Lens out = *this;
  out.k1 = out.k2 = out.p1 = out.p2 = out.k3 = 0;
  return out;
}

Vec2 Lens::undistorted_pixel(const Vec2& pixel) const {
  const Vec3 direction = ray(pixel);
  return {fx * direction.x() + cx, fy * direction.y() + cy};
}

Lens Lens::scaled(int to_width, int to_height) const {
  const double sx = static_cast<double>(to_width) / width, sy = static_cast<double>(to_height) / height;
  Lens out = *this;
  out.width = to_width;
  out.height = to_height;
  out.fx *= sx;
  out.fy *= sy;
  out.cx = (cx + 0.5) * sx - 0.5;
  out.cy = (cy + 0.5) * sy - 0.5;
  return out;
}

}  // namespace prosector
