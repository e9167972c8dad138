#pragma once
// Poses of a headset's user, room frame.

#include <array>
#include <cstdint>
#include <optional>

#include "common/hand_pose.h"
#include "common/math.h"

namespace prosector {

inline constexpr std::uint32_t menu_button = 1;  // bit of a controller's menu, A or X button

struct TrackedHand {
  Pose wrist;                             // −z towards the fingers, +y out of the back of the hand
  std::array<double, fingers> flexion{};  // 0 open … 1 closed fist, thumb first
  std::uint32_t buttons = 0;              // of a controller: menu_button, or 0
};

struct TrackedUser {
  std::int64_t time_ns = 0;                           // monotonic
  std::optional<Pose> head = {};                      // pose of the eyes; nullopt: not tracked
  std::array<std::optional<TrackedHand>, 2> hands{};  // left_hand, right_hand; nullopt: not tracked
};

}  // namespace prosector
