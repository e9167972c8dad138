#pragma once
// Simulates a camera's optics, sensor and compression on the light of an exact image.

#include <cstdint>
#include <vector>

#include "common/image.h"
#include "twins/camera/texture.h"

namespace prosector {

struct Sensor {
  double light = 1;       // factor of the incoming light; below 1 is a dark room with unchanged noise
  double blur = 0.5;      // pixels: standard deviation of the point spread function
  double noise = 3;       // grey values, 0 to 255: standard deviation, independent per pixel and colour
  double response = 2.2;  // exponent from light to bytes: 1, or 2.2 as in sRGB
  int jpeg = 0;           // JPEG quality; 0: no compression
  unsigned seed = 1;
};

/// Computes the image that a simulated camera sensor makes of `light` (`width` × `height` values, rows from
/// the top), with blur, noise, response and compression. The result is determined by the sensor's seed and
/// the image number.
Image expose(const Sensor& sensor, int width, int height, std::vector<Rgb> light, std::uint64_t number);

}  // namespace prosector
