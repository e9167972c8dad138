#pragma once
// Orthographic projection of points in space to the view.

#include "common/math.h"

namespace prosector {

struct OrthographicView {
  float x = 0, y = 0;            // position of the origin, pixels from the top left
  float scale = 1;               // pixels per metre
  Mat3 view = Mat3::Identity();  // rows: right, up, towards the viewer

  template <class Point>
  Point at(const Vec3& place) const {
    const Vec3 v = view * place;
    return Point{x + scale * static_cast<float>(v.x()), y - scale * static_cast<float>(v.y())};
  }
  double nearness(const Vec3& place) const { return (view * place).z(); }
};

/// Returns the rotation for OrthographicView::view of a viewer that looks down by the angle `down` and is
/// displaced to the right by the angle `right`, both in rad.
inline Mat3 seen_from(double down, double right) {
  return (Eigen::AngleAxisd(down, Vec3::UnitX()) * Eigen::AngleAxisd(-right, Vec3::UnitY()))
      .toRotationMatrix();
}

}  // namespace prosector
