#pragma once
// What is printed on a flat thing of a synthetic scene.

#include <array>
#include <cstdint>
#include <vector>

#include "common/image.h"

namespace prosector {

using Rgb = std::array<float, 3>;  // light, linear: 0 none, 1 all that white paper gives back

/// Turns sRGB bytes into light and back, by a power law; 1: the bytes are light.
class Response {
 public:
  explicit Response(double exponent);
  float light(std::uint8_t byte) const { return light_[byte]; }
  /// Returns the byte, not yet rounded; what is brighter than white stays at 255.
  float byte(float light) const;

 private:
  double exponent_;
  std::array<float, 256> light_;
};

/// A picture stretched over a rectangle, coarser copies of it included.
class Texture {
 public:
  /// Makes it of a picture. `smooth`: interpolated between its pixels; else each is a cell with sharp edges.
  Texture(const Image& image, bool smooth, const Response& response);

  int width() const { return levels_.front().width; }
  /// Returns the level whose pixels are about `ratio` of the first one's large.
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

/// Returns wood-like noise, the same for the same seed.
Image wood(int side, unsigned seed);

}  // namespace prosector
