#include "server/physics/mechanics/cutting/tet_shape.h"

#include <algorithm>

namespace prosector::cutting {

double cos_least_dihedral(const std::array<Vec3, 4>& x) {
  const Vec3 e1 = x[1] - x[0], e2 = x[2] - x[0], e3 = x[3] - x[0];
  std::array<Vec3, 4> out = {Vec3::Zero(), e3.cross(e2), e1.cross(e3), e2.cross(e1)};
  out[0] = -(out[1] + out[2] + out[3]);  // the area vectors of a closed surface sum to zero
  for (Vec3& n : out) {
    const double length = n.norm();
    if (!(length > 0)) return 1;
    n /= length;
  }
  double most = -1;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) most = std::max(most, -out[i].dot(out[j]));
  return std::min(most, 1.0);
}

double cos_least_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const std::array<Vec3, 3> x = {a, b, c};
  double most = -1;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 e = x[(k + 1) % 3] - x[k], f = x[(k + 2) % 3] - x[k];
    const double lengths = e.norm() * f.norm();
    if (!(lengths > 0)) return 1;
    most = std::max(most, e.dot(f) / lengths);
  }
  return std::min(most, 1.0);
}

}  // namespace prosector::cutting
