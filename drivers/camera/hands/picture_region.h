#pragma once
// A turned square of a picture, as a network takes it in.

#include <span>

#include "common/image.h"
#include "drivers/camera/lens.h"

namespace prosector {

struct PictureRegion {
  Vec2 center = Vec2::Zero();  // pixels of the picture
  double side = 0;             // pixels of the picture
  double angle = 0;            // rad, from the picture's up to the square's up, clockwise

  /// Returns the pixel at (u, v) of the square, each from 0 to 1, from its upper left.
  Vec2 pixel(const Vec2& at) const;
};

/// Tells whether a picture has all its pixels, and one at least.
bool is_whole(const Image& image);

/// What is taken for what lies outside of a picture.
enum class Outside : std::uint8_t { black, edge };

/// Writes the square as size × size pixels of red, green, blue, each from 0 to 1.
void sample_region(const Image& image, const PictureRegion& region, std::size_t size, Outside outside,
                   std::span<float> out);

/// Brightens dark pixels of red, green, blue, each from 0 to 1, as more light would: networks were trained on
/// well exposed pictures. Leaves alone what is bright enough, and what is nearly black.
void brighten(std::span<float> pixels);

}  // namespace prosector
