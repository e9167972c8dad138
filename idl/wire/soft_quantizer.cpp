#include "idl/wire/soft_quantizer.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "idl/wire/bit_stream.h"

namespace prosector {
namespace {

constexpr float float_infinity = std::numeric_limits<float>::infinity();

float rounded_down(double x) {
  const auto f = static_cast<float>(x);
  return f > x ? std::nextafter(f, -float_infinity) : f;
}
float rounded_up(double x) {
  const auto f = static_cast<float>(x);
  return f < x ? std::nextafter(f, float_infinity) : f;
}

double last_index(unsigned bits) {
  return static_cast<double>((std::uint32_t{1} << bits) - 1);
}

Grid bounding_box(std::span<const Vec3> points) {
  Grid grid;
  if (points.empty()) return grid;
  Vec3 low = points[0], high = points[0];
  for (const Vec3& x : points) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    grid.low[k] = rounded_down(low[i]);
    grid.extent[k] = rounded_up(high[i] - static_cast<double>(grid.low[k]));
  }
  return grid;
}

/// Returns the number of bits of the smallest grid over `extent` with steps of at most `quantum`; 0 if one
/// value in the middle suffices.
std::uint8_t bits_for(double extent, double quantum) {
  if (extent <= quantum) return 0;
  return static_cast<std::uint8_t>(std::bit_width(static_cast<std::uint32_t>(std::ceil(extent / quantum))));
}

}  // namespace

std::uint32_t Grid::index(double value, std::size_t component) const {
  if (bits[component] == 0) return 0;
  const double last = last_index(bits[component]);
  return static_cast<std::uint32_t>(std::llround((value - low[component]) / extent[component] * last));
}

double Grid::value(std::uint32_t index, std::size_t component) const {
  if (bits[component] == 0) return low[component] + 0.5 * extent[component];
  return low[component] + extent[component] * (index / last_index(bits[component]));
}

Grid position_grid(std::span<const Vec3> points) {
  Grid grid = bounding_box(points);
  for (std::size_t k = 0; k < 3; ++k) grid.bits[k] = bits_for(grid.extent[k], position_quantum);
  return grid;
}

Grid velocity_grid(std::span<const Vec3> points) {
  Grid grid = bounding_box(points);
  set_velocity_bits(grid);
  return grid;
}

void set_velocity_bits(Grid& grid) {
  for (std::size_t k = 0; k < 3; ++k)
    grid.bits[k] = std::min(max_velocity_bits, bits_for(grid.extent[k], velocity_quantum));
}

std::size_t packed_bytes(const Grid& positions, const Grid& velocities, std::size_t count) {
  std::size_t bits = 0;
  for (std::size_t k = 0; k < 3; ++k) bits += positions.bits[k] + velocities.bits[k];
  return (bits * count + 7) / 8;
}

void pack(const Grid& position_grid, const Grid& velocity_grid, std::span<const Vec3> positions,
          std::span<const Vec3> velocities, std::span<std::uint8_t> bytes) {
  BitWriter writer(bytes);
  const auto put = [&writer](const Grid& grid, const Vec3& v) {
    for (std::size_t k = 0; k < 3; ++k)
      writer.put(grid.index(v[static_cast<Eigen::Index>(k)], k), grid.bits[k]);
  };
  for (std::size_t i = 0; i < positions.size(); ++i) {
    put(position_grid, positions[i]);
    put(velocity_grid, velocities[i]);
  }
}

void unpack(const Grid& position_grid, const Grid& velocity_grid, std::span<const std::uint8_t> bytes,
            std::span<Vec3> positions, std::span<Vec3> velocities) {
  BitReader reader(bytes);
  const auto get = [&reader](const Grid& grid, Vec3& v) {
    for (std::size_t k = 0; k < 3; ++k)
      v[static_cast<Eigen::Index>(k)] = grid.value(reader.get(grid.bits[k]), k);
  };
  for (std::size_t i = 0; i < positions.size(); ++i) {
    get(position_grid, positions[i]);
    get(velocity_grid, velocities[i]);
  }
}

}  // namespace prosector
