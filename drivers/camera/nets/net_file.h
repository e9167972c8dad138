#pragma once
// Reader for TensorFlow Lite files (.tflite, version 3) with weights in single or half precision.

#include <filesystem>
#include <span>

#include "drivers/camera/nets/net_plan.h"

namespace prosector {

/// Parses and checks a network. Throws InputError if the bytes are no such file, are incomplete, or use a
/// layer that `LayerKind` doesn't list.
NetPlan read_net(std::span<const std::uint8_t> file);

/// Reads a network's file. Throws InputError with the file's name.
NetPlan load_net(const std::filesystem::path& file);

/// Reads a file that deploy/fetch_models.sh fetches. Throws InputError with that advice if the file is
/// missing. `what` names the feature that needs it.
NetPlan load_fetched_net(const std::filesystem::path& folder, const std::string& name,
                         const std::string& what);

/// Converts a half-precision float to single precision.
float from_half(std::uint16_t half);

}  // namespace prosector
