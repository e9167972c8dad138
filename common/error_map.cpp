#include "common/error_map.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace prosector {

std::uint8_t level_of(double error) {
  if (!(error >= min_mapped_error)) return 0;
  const double level = 1 + levels_per_decade * std::log10(error / min_mapped_error);
  return static_cast<std::uint8_t>(std::lround(std::min(level, 255.)));
}

double error_of(std::uint8_t level) {
  return level == 0 ? 0 : min_mapped_error * std::pow(10, (level - 1) / levels_per_decade);
}

std::optional<double> error_at(const ErrorMap& map, const Vec3& place) {
  if (map.levels.empty()) return std::nullopt;
  std::array<std::size_t, 3> low{};
  std::array<double, 3> share{};  // weight of the upper value
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double last = map.size[axis] - 1;
    const double at = (place[static_cast<int>(axis)] - map.corner[static_cast<int>(axis)]) / map.cell;
    const double inside = last > 0 ? std::clamp(at, 0., last) : 0;
    low[axis] = static_cast<std::size_t>(std::min(inside, std::max(0., last - 1)));
    share[axis] = inside - static_cast<double>(low[axis]);
  }
  double sum = 0;
  for (std::size_t corner = 0; corner < 8; ++corner) {
    double weight = 1;
    std::array<std::size_t, 3> at = low;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const bool upper = (corner >> axis & 1) != 0;
      weight *= upper ? share[axis] : 1 - share[axis];
      if (upper && share[axis] > 0) ++at[axis];
    }
    if (weight > 0) sum += weight * error_of(map.levels[(at[2] * map.size[1] + at[1]) * map.size[0] + at[0]]);
  }
  return sum;
}

}  // namespace prosector
