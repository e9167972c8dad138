#pragma once
// Selection of the networks that find bare hands.

#include <cstdint>

namespace prosector {

/// Accuracy and cost of the networks.
enum class HandNets : std::uint8_t { lite, full };

/// Greatest distance of a user's hands from the camera, m.
inline constexpr double default_hand_range = 1.2;

}  // namespace prosector
