#pragma once
// Reading of INRIMAGE-4 (.inr) and single-file NIfTI-1 (.nii) volumes, plain or gzipped.

#include <filesystem>
#include <span>
#include <string>

#include "common/anatomy/volume.h"

namespace prosector {

/// Reads a medical volume file; the format is detected from the content. Throws InputError that names the
/// file for
///   truncated or corrupt content,
///   dimensions or a voxel size out of range (checked before memory is allocated for them),
///   an unknown voxel type, and
///   a NaN or infinite voxel, with its index.
Volume load_volume(const std::filesystem::path& file);

/// Parses the bytes of a medical volume file, with the same checks as load_volume(); `name` is used in
/// messages.
Volume parse_volume(std::span<const std::uint8_t> bytes, const std::string& name);

}  // namespace prosector
