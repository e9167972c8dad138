#include "twins/camera/painted_clock.h"

#include <algorithm>
#include <array>
#include <bit>

namespace prosector {

void paint_clock(Image& picture, std::int64_t time_ns) {
  const auto ms = static_cast<std::uint16_t>(time_ns / 1'000'000);
  std::array<bool, clock_cells> cells = {true, false};
  for (std::size_t bit = 0; bit < clock_bits; ++bit) cells[2 + bit] = ((ms >> bit) & 1) != 0;
  const bool parity = std::popcount(ms) % 2 != 0;
  cells[clock_bits + 2] = parity;
  cells[clock_bits + 3] = !parity;
  const int side = clock_cell(picture.width), left = (picture.width - side * clock_cells) / 2;
  for (int y = 0; y < std::min(side, picture.height); ++y)
    for (int x = 0; x < side * clock_cells; ++x) {
      const std::uint8_t shade = cells[static_cast<std::size_t>(x / side)] ? 255 : 0;
      const std::size_t at = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                                  static_cast<std::size_t>(left + x));
      std::fill_n(picture.rgb.begin() + static_cast<std::ptrdiff_t>(at), 3, shade);
    }
}

}  // namespace prosector
