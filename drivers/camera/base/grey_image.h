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

/// Converts a colour image to grey values by the luma weights of BT.601.
GreyImage grey_of(const Image& image);
/// Returns the mean grey value of an image, 0 to 255; 0 for an empty image.
double brightness_of(const GreyImage& image);

}  // namespace prosector
