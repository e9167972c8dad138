#pragma once
// Many pictures on one.

#include <vector>

#include "client/render/image.h"

namespace prosector {

/// `width` pixels wide and as high as its shape makes it, each the mean of the pixels that it covers. Throws
/// std::invalid_argument for a width below 1.
Image shrunk(const Image& picture, int width);

/// Row by row in `columns`, each picture scaled to `tile_width` pixels by averaging the pixels that it
/// covers, with a dark gap between. Row heights are those of the first picture. Throws std::invalid_argument
/// without pictures or for a width or column count below 1.
Image contact_sheet(const std::vector<Image>& pictures, int columns, int tile_width);

}  // namespace prosector
