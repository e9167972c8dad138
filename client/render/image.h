#pragma once
// Pictures as PNG files.

#include <filesystem>

#include "common/image.h"

namespace prosector {

/// Writes the image. Throws InputError when the file cannot be written.
void write_png(const Image& image, const std::filesystem::path& file);

/// Reads an image; alpha is dropped. Throws InputError when the file cannot be read or is no PNG.
Image read_png(const std::filesystem::path& file);

}  // namespace prosector
