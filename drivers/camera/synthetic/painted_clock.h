#pragma once
// A clock painted into pictures, so that whoever sees one knows how old it is.
//
// A row of square cells in the upper border's middle, white for 1: one, zero, the milliseconds of
// monotonic_ns() in 16 bits, lowest first, their parity and its opposite. Borders are the least bent there.

#include <cstdint>

#include "common/image.h"

namespace prosector {

inline constexpr int clock_cells = 20, clock_bits = 16;

/// Returns the side of a clock's cell in pictures of that width, pixels.
constexpr int clock_cell(int width) {
  return width / (2 * clock_cells);
}

/// Paints that time over a picture.
void paint_clock(Image& picture, std::int64_t time_ns);

}  // namespace prosector
