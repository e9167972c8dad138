#pragma once
// Contact sheets: many images on one.

#include <vector>

#include "client/render/image.h"

namespace prosector {

/// Scales the image to `width` pixels, keeping its aspect ratio, by averaging the covered pixels. Throws
/// std::invalid_argument for a width below 1.
Image shrunk(const Image& picture, int width);

/// Arranges the images row by row in `columns`, with a dark gap between. Scales each to `tile_width` pixels
/// by averaging the covered pixels. All rows have the height of the first image. Throws std::invalid_argument
/// without images or for a width or column count below 1.
Image contact_sheet(const std::vector<Image>& pictures, int columns, int tile_width);

}  // namespace prosector
