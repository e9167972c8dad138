#pragma once
// Grey-scale images, in which fiducials are detected.

#include <cstdint>
#include <vector>

#include "common/image.h"

namespace prosector {

struct GreyImage {
  int width = 0, height = 0;
  std::vector<std::uint8_t> grey;  // row by row from the top
};

/// Returns the luma (BT.601) of an image.
GreyImage grey_of(const Image& image);
/// Returns the mean grey value, 0 to 255.
double brightness_of(const GreyImage& image);

}  // namespace prosector
