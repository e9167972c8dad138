#pragma once
// INRIMAGE-4 (.inr) and single-file NIfTI-1 (.nii) volumes, plain or gzipped.

#include <filesystem>
#include <span>
#include <string>

#include "common/anatomy/volume.h"

namespace prosector {

/// Reads a volume, its format recognised from the content. Throws InputError with the file and what is wrong:
///   truncated or damaged
///   dims or voxel size out of range, found before anything is allocated for them
///   unknown voxel type
///   NaN or infinite voxel, with its index
Volume load_volume(const std::filesystem::path& file);

/// Reads a volume from the file's bytes as load_volume does; `name` is for messages.
Volume parse_volume(std::span<const std::uint8_t> bytes, const std::string& name);

}  // namespace prosector
