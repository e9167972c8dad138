#pragma once
// Pictures from files.

#include <filesystem>

#include "common/image.h"

namespace prosector {

/// Reads any picture that OpenCV can. Throws InputError where it can't.
Image read_picture(const std::filesystem::path& file);

}  // namespace prosector
