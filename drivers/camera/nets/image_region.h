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

  /// Returns the image position, in pixels, of the point (u, v) of this square. u and v run from 0 to 1, from
  /// the square's upper left corner.
  Vec2 pixel(const Vec2& at) const;
};

/// Reports whether an image is not empty and has as many colour values as its width and height require.
bool is_whole(const Image& image);

/// Choice of the values that stand for pixels outside the image: black, or the nearest pixel at the image's
/// edge.
enum class Outside : std::uint8_t { black, edge };

/// Samples a rotated square of the image as size × size pixels. Writes red, green and blue of each pixel,
/// from 0 to 1, to `out`, row by row. `outside` gives the values beyond the image.
void sample_region(const Image& image, const ImageRegion& region, std::size_t size, Outside outside,
                   std::span<float> out);

/// Brightens pixels (red, green, blue of each, from 0 to 1) of a dark image, like a longer exposure, because
/// the networks were trained on well exposed images. Leaves images unchanged that are bright enough or nearly
/// black.
void brighten(std::span<float> pixels);

}  // namespace prosector
