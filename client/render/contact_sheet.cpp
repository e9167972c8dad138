#include "client/render/contact_sheet.h"

#include <algorithm>
#include <stdexcept>

namespace prosector {
namespace {

constexpr int gap = 4;  // pixels
constexpr std::uint8_t gap_gray = 24;

struct Span {
  int first, end;  // of the picture's pixels, never empty
};

Span covered(int tile, int tiles, int pixels) {
  const int first = static_cast<int>(static_cast<long>(tile) * pixels / tiles);
  const int end = static_cast<int>(static_cast<long>(tile + 1) * pixels / tiles);
  return {first, std::max(end, first + 1)};
}

std::uint8_t mean(const Image& image, Span across, Span down, int channel) {
  int sum = 0;
  for (int y = down.first; y < down.end; ++y)
    for (int x = across.first; x < across.end; ++x) sum += image.pixel(x, y)[channel];
  const int count = (across.end - across.first) * (down.end - down.first);
  return static_cast<std::uint8_t>((sum + count / 2) / count);
}

}  // namespace

Image contact_sheet(const std::vector<Image>& pictures, int columns, int tile_width) {
  if (pictures.empty() || columns < 1 || tile_width < 1)
    throw std::invalid_argument("contact_sheet: no pictures, or nothing to put them in");
  const int count = static_cast<int>(pictures.size());
  columns = std::min(columns, count);
  const int rows = (count + columns - 1) / columns;
  const int tile_height = std::max(1, tile_width * pictures[0].height / pictures[0].width);
  Image out{columns * (tile_width + gap) + gap, rows * (tile_height + gap) + gap, {}};
  out.rgb.assign(3 * static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height), gap_gray);
  for (int k = 0; k < count; ++k) {
    const Image& from = pictures[static_cast<std::size_t>(k)];
    const int left = gap + k % columns * (tile_width + gap), top = gap + k / columns * (tile_height + gap);
    for (int y = 0; y < tile_height; ++y)
      for (int x = 0; x < tile_width; ++x)
        for (int channel = 0; channel < 3; ++channel) {
          const auto at = static_cast<std::size_t>(top + y) * static_cast<std::size_t>(out.width) +
                          static_cast<std::size_t>(left + x);
          out.rgb[3 * at + static_cast<std::size_t>(channel)] =
              mean(from, covered(x, tile_width, from.width), covered(y, tile_height, from.height), channel);
        }
  }
  return out;
}

}  // namespace prosector
