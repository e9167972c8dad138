#pragma once
// Which networks find bare hands.

#include <cstdint>

namespace prosector {

/// How well networks find, and how dearly.
enum class HandNets : std::uint8_t { lite, full };

}  // namespace prosector
