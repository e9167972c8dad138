#include "drivers/camera/base/grey_image.h"

#include <numeric>

#include <cstddef>

namespace prosector {

GreyImage grey_of(const Image& image) {
  GreyImage out{image.width, image.height, {}};
  out.grey.resize(image.rgb.size() / 3);
  // The weights are 0.299, 0.587 and 0.114, times 256.
  for (std::size_t i = 0; i < out.grey.size(); ++i)
    out.grey[i] = static_cast<std::uint8_t>(
        (77u * image.rgb[3 * i] + 150u * image.rgb[3 * i + 1] + 29u * image.rgb[3 * i + 2] + 128u) >> 8);
  return out;
}

double brightness_of(const GreyImage& image) {
  if (image.grey.empty()) return 0;
  return std::accumulate(image.grey.begin(), image.grey.end(), 0.0) / static_cast<double>(image.grey.size());
}

}  // namespace prosector
