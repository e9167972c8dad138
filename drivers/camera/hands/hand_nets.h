#pragma once
// Which networks find bare hands.

#include <cstdint>

namespace prosector {

/// How well networks find, and how dearly.
enum class HandNets : std::uint8_t { lite, full };

/// Distance of a user's hands from the camera at most, m.
inline constexpr double usual_hand_range = 1.2;

}  // namespace prosector
