#pragma once
// What a camera's optics, sensor and compression do to the light of an exact picture.

#include <cstdint>
#include <vector>

#include "common/image.h"
#include "drivers/camera/synthetic/texture.h"

namespace prosector {

struct Sensor {
  double light = 1;       // that falls in; less is a dark room, whose noise stays
  double blur = 0.5;      // pixels: standard deviation of a point's image
  double noise = 3;       // of 255: standard deviation, each pixel and colour by itself
  double response = 2.2;  // exponent from light to bytes: 1 or as sRGB has it
  int jpeg = 0;           // quality of JPEG's compression; 0: none
  unsigned seed = 1;
};

/// Returns the picture that the sensor makes of light (`width` × `height`, rows from the top). The same for
/// the same seed and picture number.
Image expose(const Sensor& sensor, int width, int height, std::vector<Rgb> light, std::uint64_t number);

}  // namespace prosector
