#pragma once
// A user as a headset tracks them, in the room.

#include <array>
#include <cstdint>
#include <optional>

#include "common/messages.h"

namespace prosector {

inline constexpr std::uint32_t menu_button = 1;  // of a controller: its menu, A or X

struct TrackedHand {
  Pose wrist;                             // −z towards the fingers, +y out of the back of the hand
  std::array<double, fingers> flexion{};  // 0 open … 1 closed fist, thumb first
  std::uint32_t buttons = 0;              // of a controller: menu_button
};

struct TrackedUser {
  std::int64_t time_ns = 0;                           // monotonic
  std::optional<Pose> head = {};                      // eyes; nullopt: not seen
  std::array<std::optional<TrackedHand>, 2> hands{};  // left_hand, right_hand; nullopt: not seen
};

}  // namespace prosector
