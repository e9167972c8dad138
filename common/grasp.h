#pragma once
// What a command to grasp means by its `revision`.

#include <cstdint>

namespace prosector {

/// Says that the command's `body` is wanted; with any other revision the nearest one is.
inline constexpr std::uint32_t grasps_body = 1;

}  // namespace prosector
