#pragma once
// Images as PNG files.

#include <filesystem>

#include "common/image.h"

namespace prosector {

/// Writes the image to a PNG file. Throws InputError if the file cannot be written.
void write_png(const Image& image, const std::filesystem::path& file);

/// Reads a PNG file as an RGB image, without its alpha channel. Throws InputError if the file cannot be read
/// or is not a PNG.
Image read_png(const std::filesystem::path& file);

}  // namespace prosector
