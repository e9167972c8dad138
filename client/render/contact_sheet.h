#pragma once
// Many pictures on one.

#include <vector>

#include "client/render/image.h"

namespace prosector {

/// Shrinks the picture to `width` pixels, as high as its shape makes it, each the mean of the pixels that it
/// covers. Throws std::invalid_argument for a width below 1.
Image shrunk(const Image& picture, int width);

/// Lays the pictures row by row in `columns`, with a dark gap between. Each is scaled to `tile_width` pixels
/// by averaging the pixels that it covers. Row heights are those of the first picture. Throws
/// std::invalid_argument without pictures or for a width or column count below 1.
Image contact_sheet(const std::vector<Image>& pictures, int columns, int tile_width);

}  // namespace prosector
