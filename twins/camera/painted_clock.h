#pragma once
// A clock painted into images, from which any viewer can compute an image's age.
//
// It is a row of square cells in the middle of the upper border, where distortion is small. White is 1. The
// bits are: one, zero, the lowest 16 bits of the milliseconds of monotonic_ns() from the lowest up, their
// parity, and the inverted parity.

#include <cstdint>

#include "common/image.h"

namespace prosector {

inline constexpr int clock_cells = 20, clock_bits = 16;

/// Returns the side, in pixels, of one cell of the clock that is painted into images of this width.
constexpr int clock_cell(int width) {
  return width / (2 * clock_cells);
}

/// Paints the milliseconds of the time `time_ns`, coded as black and white cells, over the upper border of an
/// image.
void paint_clock(Image& picture, std::int64_t time_ns);

}  // namespace prosector
