#pragma once
// Selection of the networks that find bare hands.

#include <cstdint>

namespace prosector {

/// Choice of the neural networks that detect bare hands. `lite` takes about two thirds of the time of `full`
/// and is less accurate.
enum class HandNets : std::uint8_t { lite, full };

/// Default distance from the camera, m, beyond which hands are ignored as those of bystanders.
inline constexpr double default_hand_range = 1.2;

}  // namespace prosector
