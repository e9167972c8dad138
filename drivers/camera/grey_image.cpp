#include "drivers/camera/grey_image.h"

#include <cstddef>

namespace prosector {

GreyImage grey_of(const Image& image) {
  GreyImage out{image.width, image.height, {}};
  out.grey.resize(image.rgb.size() / 3);
  // 0.299, 0.587 and 0.114 of 256.
  for (std::size_t i = 0; i < out.grey.size(); ++i)
    out.grey[i] = static_cast<std::uint8_t>(
        (77u * image.rgb[3 * i] + 150u * image.rgb[3 * i + 1] + 29u * image.rgb[3 * i + 2] + 128u) >> 8);
  return out;
}

}  // namespace prosector
