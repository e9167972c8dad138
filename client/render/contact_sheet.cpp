#include "client/render/contact_sheet.h"

#include <algorithm>
#include <stdexcept>

namespace prosector {
namespace {

constexpr int gap = 4;  // pixels
constexpr std::uint8_t gap_gray = 24;

struct Span {
  int first, end;  // pixels of the image, never empty
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

Image scaled(const Image& from, int width, int height) {
  Image out{width, height, {}};
  out.rgb.reserve(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int channel = 0; channel < 3; ++channel)
        out.rgb.push_back(
            mean(from, covered(x, width, from.width), covered(y, height, from.height), channel));
  return out;
}

int height_of(const Image& picture, int width) {
  return std::max(1, width * picture.height / picture.width);
}

}  // namespace

Image shrunk(const Image& picture, int width) {
  if (width < 1) throw std::invalid_argument("shrunk: empty image");
  return scaled(picture, width, height_of(picture, width));
}

Image contact_sheet(const std::vector<Image>& pictures, int columns, int tile_width) {
  if (pictures.empty() || columns < 1 || tile_width < 1)
    throw std::invalid_argument(
        "contact_sheet: needs at least one frame, one column and a tile width of one pixel");
  const int count = static_cast<int>(pictures.size());
  columns = std::min(columns, count);
  const int rows = (count + columns - 1) / columns;
  const int tile_height = height_of(pictures[0], tile_width);
  Image out{columns * (tile_width + gap) + gap, rows * (tile_height + gap) + gap, {}};
  out.rgb.assign(3 * static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height), gap_gray);
  const auto row_bytes = [](const Image& image) { return 3 * static_cast<std::ptrdiff_t>(image.width); };
  for (int k = 0; k < count; ++k) {
    const Image tile = scaled(pictures[static_cast<std::size_t>(k)], tile_width, tile_height);
    const int left = gap + k % columns * (tile_width + gap), top = gap + k / columns * (tile_height + gap);
    for (int y = 0; y < tile_height; ++y)
      std::copy_n(tile.rgb.begin() + y * row_bytes(tile), row_bytes(tile),
                  out.rgb.begin() + (top + y) * row_bytes(out) + 3 * left);
  }
  return out;
}

}  // namespace prosector
