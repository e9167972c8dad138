#pragma once
// Contact sheets: many images on one.

#include <vector>

#include "client/render/image.h"

namespace prosector {

/// Returns the image scaled to `width` pixels with its aspect ratio. Each new pixel is the average of the
/// pixels that it covers. Throws std::invalid_argument for a width below 1.
Image shrunk(const Image& picture, int width);

/// Returns one image with all images arranged row by row in `columns` columns, with dark gaps between. Each
/// is scaled to `tile_width` pixels and to the height that the first image then has. Throws
/// std::invalid_argument without images or for a width or column count below 1.
Image contact_sheet(const std::vector<Image>& pictures, int columns, int tile_width);

}  // namespace prosector
