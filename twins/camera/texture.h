#pragma once
// Texture of a flat object in a synthetic scene.

#include <array>
#include <cstdint>
#include <vector>

#include "common/image.h"

namespace prosector {

using Rgb = std::array<float, 3>;  // linear light: 0 none, 1 fully lit white paper

/// Converter between bytes of an image and linear light (0 to 1) by a power law. With the exponent 1, bytes
/// are proportional to light.
class Response {
 public:
  explicit Response(double exponent);
  float light(std::uint8_t byte) const { return light_[byte]; }
  /// Returns the byte value, from 0 to 255 and not rounded, that represents this linear light. Light is
  /// limited to 0 … 1.
  float byte(float light) const;

 private:
  double exponent_;
  std::array<float, 256> light_;
};

/// An image that covers a rectangle of a synthetic scene, with copies of lower resolution for distant views
/// (mipmap).
class Texture {
 public:
  /// Converts the image to linear light and builds the copies of lower resolution. If `smooth` is false,
  /// there are none, and each pixel is a cell with sharp edges instead of being interpolated.
  Texture(const Image& image, bool smooth, const Response& response);

  int width() const { return levels_.front().width; }
  /// Returns the index of the copy of the image whose pixels are about `ratio` times as large as those of the
  /// image itself (index 0).
  std::size_t level(double ratio) const;
  /// Returns the linear light of the texture's copy number `level` at (u, v), each from 0 to 1, counted from
  /// the upper left.
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

/// Returns a square image of side × side pixels with wood-like noise, determined by the seed.
Image wood(int side, unsigned seed);

}  // namespace prosector
