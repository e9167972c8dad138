#pragma once
// An image in memory.

#include <cstdint>
#include <vector>

namespace prosector {

/// An 8-bit sRGB image in memory: three bytes per pixel, rows from the top.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;

  const std::uint8_t* pixel(int x, int y) const {
    return rgb.data() +
           3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
  }
  bool operator==(const Image&) const = default;
};

}  // namespace prosector
