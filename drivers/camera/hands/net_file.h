#pragma once
// Networks in TensorFlow Lite's files (.tflite, version 3), with floats or half-precision floats as weights.

#include <filesystem>
#include <span>

#include "drivers/camera/hands/net_plan.h"

namespace prosector {

/// Returns the network in these bytes, checked. Throws InputError for what is no such file, is torn, or uses
/// what `LayerKind` doesn't list.
NetPlan read_net(std::span<const std::uint8_t> file);

/// Reads a file. Throws InputError that names it.
NetPlan load_net(const std::filesystem::path& file);

/// Reads a file that deploy/fetch_models.sh fetches. Throws InputError that says so where it isn't there;
/// `what` needs it.
NetPlan load_fetched_net(const std::filesystem::path& folder, const std::string& name,
                         const std::string& what);

/// Returns the number that a half-precision float stands for.
float from_half(std::uint16_t half);

}  // namespace prosector
