#pragma once
// Vectors as integers within their own bounding box: uniform scalar quantisation, a grid per chunk and
// component, with as many bits as its extent asks for. A value is never clamped: a wider chunk gets a wider
// box and more bits.

#include <array>
#include <cstdint>
#include <span>

#include "common/math.h"

namespace prosector {

inline constexpr double position_quantum = 3e-5;  // m: widest grid step; the error is at most half of it
// m/s: widest grid step of velocities, up to max_velocity_bits. Cubic Hermite over h seconds weighs the
// velocities' errors with h/4 at most: 0.008 mm a component between two ticks at 60 Hz.
inline constexpr double velocity_quantum = 4e-3;
inline constexpr std::uint8_t max_velocity_bits = 8;  // error beyond: range / 255 / 2
inline constexpr unsigned max_component_bits = 26;    // covers 2·max_coordinate at position_quantum

/// A grid over the box [low, low + extent] with 2^bits points a component; with 0 bits, its middle. The box
/// is kept as floats, the way it travels, so that both ends compute the same grid.
struct Grid {
  std::array<float, 3> low{}, extent{};
  std::array<std::uint8_t, 3> bits{};

  std::uint32_t index(double value, std::size_t component) const;
  double value(std::uint32_t index, std::size_t component) const;
};

/// Returns the smallest grid over `points` with steps of at most position_quantum.
Grid position_grid(std::span<const Vec3> points);
/// Returns the smallest grid over `points` with steps of at most velocity_quantum, or max_velocity_bits.
Grid velocity_grid(std::span<const Vec3> points);
/// Sets the bits, which follow from the extent (finite), so they don't travel.
void set_velocity_bits(Grid& grid);

/// Returns the bytes of `count` points packed on these two grids.
std::size_t packed_bytes(const Grid& positions, const Grid& velocities, std::size_t count);
/// Packs point by point, position then velocity; `bytes` are zero and packed_bytes() long.
void pack(const Grid& position_grid, const Grid& velocity_grid, std::span<const Vec3> positions,
          std::span<const Vec3> velocities, std::span<std::uint8_t> bytes);
void unpack(const Grid& position_grid, const Grid& velocity_grid, std::span<const std::uint8_t> bytes,
            std::span<Vec3> positions, std::span<Vec3> velocities);

}  // namespace prosector
