#include "twins/camera/ray_grid.h"

#include <numeric>

namespace prosector {

RayGrid::RayGrid(const Lens& lens, int side) : lens_(lens) {
  const int rays = side * side;
  // A stride coprime to the number of rays gives neighbours distant times.
  int stride = side + 1;
  while (rays > 1 && std::gcd(stride, rays) != 1) ++stride;
  for (int k = 0; k < rays; ++k)
    offsets_.push_back({static_cast<float>((k % side + 0.5) / side),
                        static_cast<float>((k / side + 0.5) / side),
                        ((k * stride) % rays + 0.5) / rays - 0.5});
  for (int y = 0; y <= lens.height; ++y)
    for (int x = 0; x <= lens.width; ++x)
      corners_.emplace_back(lens.ray({x - 0.5, y - 0.5}).head<2>().cast<float>());
}

Eigen::Vector2f RayGrid::direction(int x, int y, std::size_t ray) const {
  const Offset& at = offsets_[ray];
  const auto stride = static_cast<std::size_t>(lens_.width + 1);
  const std::size_t first = static_cast<std::size_t>(y) * stride + static_cast<std::size_t>(x);
  return (1 - at.y) * ((1 - at.x) * corners_[first] + at.x * corners_[first + 1]) +
         at.y * ((1 - at.x) * corners_[first + stride] + at.x * corners_[first + stride + 1]);
}

double RayGrid::moment(const Exposure& exposure, int y, std::size_t ray) const {
  const double row = lens_.height > 1 ? static_cast<double>(y) / (lens_.height - 1) - 0.5 : 0;
  return exposure.middle + exposure.readout * row + exposure.length * offsets_[ray].when;
}

}  // namespace prosector
