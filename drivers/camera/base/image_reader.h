#pragma once
// Reads image files.

#include <cstddef>
#include <filesystem>
#include <optional>

#include "common/image.h"

namespace prosector {

inline constexpr std::size_t max_image_pixels = 1 << 26;

/// Reads any image format that OpenCV can read; returns nothing on failure. Throws InputError if the image
/// has more than `max_image_pixels`.
std::optional<Image> try_read_image(const std::filesystem::path& file);

/// Reads any image format that OpenCV can read. Throws InputError on failure.
Image read_image(const std::filesystem::path& file);

}  // namespace prosector
