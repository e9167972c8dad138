#pragma once
// A rotated square of an image, the input of a network.

#include <span>

#include "common/image.h"
#include "drivers/camera/base/lens.h"

namespace prosector {

struct ImageRegion {
  Vec2 center = Vec2::Zero();  // pixels of the image
  double side = 0;             // pixels of the image
  double angle = 0;            // rad, clockwise from the image's up direction to the square's

  /// Returns the image position, in pixels, of the point (u, v) of the square, each from 0 to 1 from its
  /// upper left.
  Vec2 pixel(const Vec2& at) const;
};

/// Reports whether an image has all its pixels, and at least one.
bool is_whole(const Image& image);

/// Values used for pixels outside the image.
enum class Outside : std::uint8_t { black, edge };

/// Samples the square as size × size pixels of red, green, blue, each from 0 to 1.
void sample_region(const Image& image, const ImageRegion& region, std::size_t size, Outside outside,
                   std::span<float> out);

/// Brightens dark pixels of red, green, blue, each from 0 to 1, like a longer exposure. Networks were trained
/// on well exposed images. Leaves images unchanged that are bright enough or nearly black.
void brighten(std::span<float> pixels);

}  // namespace prosector
