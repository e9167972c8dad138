#pragma once
// INRIMAGE-4 (.inr) and single-file NIfTI-1 (.nii) volumes, plain or gzipped.

#include <filesystem>
#include <span>
#include <string>

#include "common/anatomy/volume.h"

namespace prosector {

/// Recognises the format from the content. Throws InputError with the file and what is wrong: truncated,
/// damaged, dims or voxel size out of range (before anything is allocated for them), unknown voxel type,
/// NaN or infinite voxel (with its index).
Volume load_volume(const std::filesystem::path& file);

/// The same from the file's bytes; `name` is for messages.
Volume parse_volume(std::span<const std::uint8_t> bytes, const std::string& name);

}  // namespace prosector
