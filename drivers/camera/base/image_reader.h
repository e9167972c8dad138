#pragma once
// Reads image files.

#include <cstddef>
#include <filesystem>
#include <optional>

#include "common/image.h"

namespace prosector {

inline constexpr std::size_t max_image_pixels = 1 << 26;

/// Reads an image file in any format that OpenCV can read. Returns nothing if it is not a readable image.
/// Throws InputError if the image has more than `max_image_pixels`.
std::optional<Image> try_read_image(const std::filesystem::path& file);

/// Reads an image file in any format that OpenCV can read. Throws InputError if it is not a readable image or
/// is too large.
Image read_image(const std::filesystem::path& file);

}  // namespace prosector
