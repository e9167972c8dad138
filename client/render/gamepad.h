#pragma once
// State of a gamepad. Buttons are named by position, because manufacturers label them differently.

#include <array>
#include <cstddef>
#include <cstdint>

namespace prosector {

enum class PadButton : std::uint8_t {
  south,
  east,
  west,
  north,  // for the right thumb
  left_bumper,
  right_bumper,
  back,
  start,
  left_stick,
  right_stick,  // pressed
  up,
  right,
  down,
  left,  // of the directional pad
};
inline constexpr std::size_t pad_buttons = 14;

struct PadStick {
  double right = 0, down = 0;  // −1 … 1
};

struct Gamepad {
  PadStick left, right;
  double left_trigger = 0, right_trigger = 0;  // 0 … 1: pulled
  std::array<bool, pad_buttons> down{};

  bool is_down(PadButton button) const { return down[static_cast<std::size_t>(button)]; }
};

}  // namespace prosector
