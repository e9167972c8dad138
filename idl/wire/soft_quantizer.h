#pragma once
// Uniform scalar quantisation of vectors within their bounding box: one grid per chunk and component, with as
// many bits as its extent requires. Values are never clamped: a larger chunk gets a larger box and more bits.

#include <array>
#include <cstdint>
#include <span>

#include "common/math.h"

namespace prosector {

inline constexpr double position_quantum = 3e-5;  // m: largest grid step; the error is at most half of it
// m/s: largest grid step of velocities, up to max_velocity_bits. Cubic Hermite interpolation over h seconds
// multiplies velocity errors by at most h/4: 0.008 mm per component between two ticks at 60 Hz.
inline constexpr double velocity_quantum = 4e-3;
inline constexpr std::uint8_t max_velocity_bits = 8;  // if more would be needed, the error is range / 255 / 2
inline constexpr unsigned max_component_bits = 26;    // covers 2·max_coordinate at position_quantum

/// A quantisation grid over the box [low, low + extent], with 2^bits points per component; 0 bits stand for
/// the middle of the box. The box is stored as floats, as it is transmitted, so that sender and receiver
/// compute the same grid.
struct Grid {
  std::array<float, 3> low{}, extent{};
  std::array<std::uint8_t, 3> bits{};

  std::uint32_t index(double value, std::size_t component) const;
  double value(std::uint32_t index, std::size_t component) const;
};

/// Returns the quantisation grid over the bounding box of `points` (m) with the fewest bits for which steps
/// are at most position_quantum.
Grid position_grid(std::span<const Vec3> points);
/// Returns the quantisation grid over the bounding box of the velocities `points` (m/s). It has the fewest
/// bits for which steps are at most velocity_quantum, but no more than max_velocity_bits.
Grid velocity_grid(std::span<const Vec3> points);
/// Sets the bits of a velocity grid from its extent, which must be finite, so that they needn't be
/// transmitted.
void set_velocity_bits(Grid& grid);

/// Returns the number of bytes of `count` points whose positions and velocities are packed on these two
/// quantisation grids.
std::size_t packed_bytes(const Grid& positions, const Grid& velocities, std::size_t count);
/// Packs the points on the two quantisation grids one by one: position, then velocity. `bytes` must be zeroed
/// and packed_bytes() long.
void pack(const Grid& position_grid, const Grid& velocity_grid, std::span<const Vec3> positions,
          std::span<const Vec3> velocities, std::span<std::uint8_t> bytes);
void unpack(const Grid& position_grid, const Grid& velocity_grid, std::span<const std::uint8_t> bytes,
            std::span<Vec3> positions, std::span<Vec3> velocities);

}  // namespace prosector
