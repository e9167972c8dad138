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

/// Returns the number that a half-precision float stands for.
float from_half(std::uint16_t half);

}  // namespace prosector
