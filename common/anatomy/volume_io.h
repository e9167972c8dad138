#pragma once
// Reading of INRIMAGE-4 (.inr) and single-file NIfTI-1 (.nii) volumes, plain or gzipped.

#include <filesystem>
#include <span>
#include <string>

#include "common/anatomy/volume.h"

namespace prosector {

/// Reads a volume; the format is detected from the content. Throws InputError with the file and the error:
///   truncated or corrupt
///   dimensions or voxel size out of range (checked before memory is allocated for them)
///   unknown voxel type
///   NaN or infinite voxel, with its index
Volume load_volume(const std::filesystem::path& file);

/// Parses a volume file's bytes as load_volume() does; `name` is used in messages.
Volume parse_volume(std::span<const std::uint8_t> bytes, const std::string& name);

}  // namespace prosector
