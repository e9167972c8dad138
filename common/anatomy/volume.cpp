#include "common/anatomy/volume.h"

#include <algorithm>
#include <cmath>

namespace prosector {

double sample(const Volume& volume, const Vec3& x) {
  std::array<std::int64_t, 3> low, high;
  std::array<double, 3> t;
  const Vec3 first = volume.position(Vec3::Zero());
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<int>(k);
    const double last = static_cast<double>(volume.dims[k] - 1);
    const double index = std::clamp((x[axis] - first[axis]) / volume.voxel_size[axis], 0.0, last);
    low[k] = static_cast<std::int64_t>(index);
    high[k] = std::min(low[k] + 1, volume.dims[k] - 1);
    t[k] = index - static_cast<double>(low[k]);
  }
  const auto row = [&](std::int64_t j, std::int64_t k) {
    return (1 - t[0]) * static_cast<double>(volume.at(low[0], j, k)) +
           t[0] * static_cast<double>(volume.at(high[0], j, k));
  };
  const auto plane = [&](std::int64_t k) { return (1 - t[1]) * row(low[1], k) + t[1] * row(high[1], k); };
  return (1 - t[2]) * plane(low[2]) + t[2] * plane(high[2]);
}

}  // namespace prosector
