#pragma once
// Reader for TensorFlow Lite files (.tflite, version 3) with weights in single or half precision.

#include <filesystem>
#include <span>

#include "drivers/camera/nets/net_plan.h"

namespace prosector {

/// Parses and checks a neural network from the bytes of a TensorFlow Lite file. Throws InputError if the
/// bytes are no such file, are incomplete, or use a layer that `LayerKind` does not list.
NetPlan read_net(std::span<const std::uint8_t> file);

/// Reads a neural network from a TensorFlow Lite file. Throws InputError with the file's name if it is
/// unreadable or invalid.
NetPlan load_net(const std::filesystem::path& file);

/// Reads the neural network `name` from `folder`, into which deploy/fetch_models.sh downloads such files. If
/// the file is missing, throws InputError with the advice to run this script. `what` names the feature that
/// needs the network.
NetPlan load_fetched_net(const std::filesystem::path& folder, const std::string& name,
                         const std::string& what);

/// Converts a half-precision floating-point number (16 bits) to single precision.
float from_half(std::uint16_t half);

}  // namespace prosector
