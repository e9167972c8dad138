#pragma once
// Brightness alone, which is what fiducials are found in.

#include <cstdint>
#include <vector>

#include "common/image.h"

namespace prosector {

struct GreyImage {
  int width = 0, height = 0;
  std::vector<std::uint8_t> grey;  // rows from the top
};

/// Returns the luma (BT.601) of a picture.
GreyImage grey_of(const Image& image);
/// Returns the mean of its pixels, 0 to 255.
double brightness_of(const GreyImage& image);

}  // namespace prosector
