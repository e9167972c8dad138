#pragma once
// Vectors as integers within their own bounding box: uniform scalar quantisation, a grid per chunk and
// component. A value is never clamped: a wider chunk gets a wider box and, for positions, more bits.

#include <array>
#include <cstdint>
#include <span>

#include "common/math.h"

namespace prosector {

inline constexpr double position_quantum = 5e-5;    // m: widest grid step; the error is at most half of it
inline constexpr unsigned velocity_bits = 8;        // error: range / 255 / 2
inline constexpr unsigned max_component_bits = 26;  // covers 2·max_coordinate at position_quantum

/// A grid over the box [low, low + extent] with 2^bits points a component. The box is kept as floats, the way
/// it travels, so that both ends compute the same grid.
struct Grid {
  std::array<float, 3> low{}, extent{};
  std::array<std::uint8_t, 3> bits{};

  std::uint32_t index(double value, std::size_t component) const;
  double value(std::uint32_t index, std::size_t component) const;
};

/// The smallest grid over `points` with steps of at most position_quantum.
Grid position_grid(std::span<const Vec3> points);
/// The grid of velocity_bits a component over `points`.
Grid velocity_grid(std::span<const Vec3> points);

/// Bytes of `count` points packed on these two grids.
std::size_t packed_bytes(const Grid& positions, const Grid& velocities, std::size_t count);
/// Packs point by point, position then velocity; `bytes` are zero and packed_bytes() long.
void pack(const Grid& position_grid, const Grid& velocity_grid, std::span<const Vec3> positions,
          std::span<const Vec3> velocities, std::span<std::uint8_t> bytes);
void unpack(const Grid& position_grid, const Grid& velocity_grid, std::span<const std::uint8_t> bytes,
            std::span<Vec3> positions, std::span<Vec3> velocities);

}  // namespace prosector
