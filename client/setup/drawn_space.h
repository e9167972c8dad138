#pragma once
// Where places of a space are on the picture, seen from one side without perspective.

#include "common/math.h"

namespace prosector {

struct DrawnSpace {
  float x = 0, y = 0;            // of the origin, pixels from the top left
  float scale = 1;               // pixels of a metre
  Mat3 view = Mat3::Identity();  // rows: to the right, up, towards whoever looks

  template <class Point>
  Point at(const Vec3& place) const {
    const Vec3 v = view * place;
    return Point{x + scale * static_cast<float>(v.x()), y - scale * static_cast<float>(v.y())};
  }
  double nearness(const Vec3& place) const { return (view * place).z(); }
};

/// Returns the view of who looks from above by `down` and from the right by `right`, rad.
inline Mat3 seen_from(double down, double right) {
  return (Eigen::AngleAxisd(down, Vec3::UnitX()) * Eigen::AngleAxisd(-right, Vec3::UnitY()))
      .toRotationMatrix();
}

}  // namespace prosector
