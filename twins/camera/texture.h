#pragma once
// Texture of a flat object in a synthetic scene.

#include <array>
#include <cstdint>
#include <vector>

#include "common/image.h"

namespace prosector {

using Rgb = std::array<float, 3>;  // linear light: 0 none, 1 fully lit white paper

/// Converts between sRGB bytes and light by a power law; with the exponent 1 bytes are proportional to light.
class Response {
 public:
  explicit Response(double exponent);
  float light(std::uint8_t byte) const { return light_[byte]; }
  /// Returns the unrounded byte, at most 255.
  float byte(float light) const;

 private:
  double exponent_;
  std::array<float, 256> light_;
};

/// An image stretched over a rectangle, with coarser copies (mipmap).
class Texture {
 public:
  /// Builds the levels. `smooth`: interpolates between pixels; otherwise each pixel is a cell with sharp
  /// edges.
  Texture(const Image& image, bool smooth, const Response& response);

  int width() const { return levels_.front().width; }
  /// Returns the level with pixels about `ratio` times as large as those of the first level.
  std::size_t level(double ratio) const;
  /// Returns the light at (u, v), each from 0 to 1, from the upper left.
  Rgb at(float u, float v, std::size_t level) const;

 private:
  struct Level {
    int width, height;
    std::vector<Rgb> pixels;
    const Rgb& pixel(int x, int y) const;
  };

  bool smooth_;
  std::vector<Level> levels_;
};

/// Returns wood-like noise, determined by the seed.
Image wood(int side, unsigned seed);

}  // namespace prosector
