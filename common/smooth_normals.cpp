#include "common/smooth_normals.h"

#include <cmath>

namespace prosector {

void smooth_normals(std::span<const Eigen::Vector3f> positions,
                    std::span<const std::array<std::uint32_t, 3>> triangles,
                    std::vector<Eigen::Vector3f>& normals) {
  normals.assign(positions.size(), Eigen::Vector3f::Zero());
  for (const auto& t : triangles) {
    const Eigen::Vector3f twice_area =
        (positions[t[1]] - positions[t[0]]).cross(positions[t[2]] - positions[t[0]]);
    for (const std::uint32_t v : t) normals[v] += twice_area;
  }
  for (Eigen::Vector3f& n : normals) {
    const float length = n.norm();
    if (length > 0 && std::isfinite(length))
      n /= length;
    else
      n = Eigen::Vector3f::UnitY();
  }
}

}  // namespace prosector
