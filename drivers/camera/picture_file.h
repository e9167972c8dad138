#pragma once
// Pictures from files.

#include <cstddef>
#include <filesystem>
#include <optional>

#include "common/image.h"

namespace prosector {

inline constexpr std::size_t most_picture_pixels = 1 << 26;

/// Reads any image that OpenCV can; nothing where it can't. Throws InputError where it has more than
/// `most_picture_pixels`.
std::optional<Image> try_picture(const std::filesystem::path& file);

/// Reads any picture that OpenCV can. Throws InputError where it can't.
Image read_picture(const std::filesystem::path& file);

}  // namespace prosector
