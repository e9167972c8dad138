#include "drivers/camera/nets/image_region.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace prosector {
namespace {

/// Adds the image's interpolated colour at a position near its border or outside it.
void add_at_border(const Image& image, int left, int top, const std::array<float, 4>& shares, Outside outside,
                   float* rgb) {
  for (int k = 0; k < 4; ++k) {
    int x = left + k % 2, y = top + k / 2;
    if (x < 0 || y < 0 || x >= image.width || y >= image.height) {
      if (outside == Outside::black) continue;
      x = std::clamp(x, 0, image.width - 1);
      y = std::clamp(y, 0, image.height - 1);
    }
    const std::uint8_t* pixel = image.pixel(x, y);
    for (int c = 0; c < 3; ++c) rgb[c] += shares[static_cast<std::size_t>(k)] * static_cast<float>(pixel[c]);
  }
}

/// Adds the image's colour at a position, with bilinear interpolation.
void add_at(const Image& image, float x, float y, Outside outside, float weight, float* rgb) {
  const float column = std::floor(x), row = std::floor(y), a = x - column, b = y - row;
  const int left = static_cast<int>(column), top = static_cast<int>(row);
  const std::array<float, 4> shares = {weight * (1 - a) * (1 - b), weight * a * (1 - b), weight * (1 - a) * b,
                                       weight * a * b};
  if (left < 0 || top < 0 || left + 1 >= image.width || top + 1 >= image.height)
    return add_at_border(image, left, top, shares, outside, rgb);
  const std::uint8_t *upper = image.pixel(left, top), *lower = image.pixel(left, top + 1);
  for (int c = 0; c < 3; ++c)
    rgb[c] += shares[0] * static_cast<float>(upper[c]) + shares[1] * static_cast<float>(upper[c + 3]) +
              shares[2] * static_cast<float>(lower[c]) + shares[3] * static_cast<float>(lower[c + 3]);
}

/// Returns the brightness that 5 % of the pixels exceed, 0 to 1; a pixel's brightness is its brightest
/// channel.
float bright_level(std::span<const float> pixels) {
  constexpr std::size_t levels = 256;
  constexpr double brighter_share = 0.05;
  std::array<std::size_t, levels> counts{};
  for (std::size_t k = 0; k + 2 < pixels.size(); k += 3) {
    const float most = std::max({pixels[k], pixels[k + 1], pixels[k + 2]});
    ++counts[static_cast<std::size_t>(std::clamp(most, 0.F, 1.F) * (levels - 1))];
  }
  const auto above = static_cast<std::size_t>(brighter_share * static_cast<double>(pixels.size() / 3));
  std::size_t level = levels - 1;
  for (std::size_t sum = counts[level]; level > 0 && sum <= above; sum += counts[level]) --level;
  return static_cast<float>(level) / (levels - 1);
}

}  // namespace

bool is_whole(const Image& image) {
  return image.width > 0 && image.height > 0 &&
         image.rgb.size() >=
             3 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
}

Vec2 ImageRegion::pixel(const Vec2& at) const {
  return center + Eigen::Rotation2Dd(angle) * Vec2((at.x() - 0.5) * side, (at.y() - 0.5) * side);
}

void sample_region(const Image& image, const ImageRegion& region, std::size_t size, Outside outside,
                   std::span<float> out) {
  std::fill(out.begin(), out.end(), 0.F);
  const double step = region.side / static_cast<double>(size);
  // A cell that covers several pixels takes several samples.
  const int samples = std::clamp(static_cast<int>(std::ceil(step / 2)), 1, 4);
  const float weight = 1.F / (255.F * static_cast<float>(samples * samples));
  const Eigen::Vector2f right = (Eigen::Rotation2Dd(region.angle) * Vec2(step, 0)).cast<float>(),
                        down(-right.y(), right.x());
  const Eigen::Vector2f first = region.pixel({0, 0}).cast<float>();
  // Clamping is exact: all positions outside the border have the same colour.
  const Eigen::Vector2f low(-2, -2),
      high(static_cast<float>(image.width + 1), static_cast<float>(image.height + 1));
  const auto part = [&](std::size_t cell, int s) {
    return static_cast<float>(cell) + (static_cast<float>(s) + 0.5F) / static_cast<float>(samples);
  };
  for (std::size_t y = 0; y < size; ++y)
    for (std::size_t x = 0; x < size; ++x)
      for (int s = 0; s < samples * samples; ++s) {
        const Eigen::Vector2f at =
            (first + part(x, s % samples) * right + part(y, s / samples) * down).cwiseMax(low).cwiseMin(high);
        add_at(image, at.x(), at.y(), outside, weight, out.data() + 3 * (y * size + x));
      }
}

void brighten(std::span<float> pixels) {
  constexpr float bright_enough = 0.5F, most_gain = 8;
  const float level = bright_level(pixels);
  if (level >= bright_enough) return;
  const float gain = std::min(bright_enough / std::max(level, 1e-3F), most_gain);
  for (float& x : pixels) x = std::min(gain * x, 1.F);
}

}  // namespace prosector
