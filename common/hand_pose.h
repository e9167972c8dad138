#pragma once
// Pose, finger bends, gesture and buttons of a user's hand, and poses of what the hand holds. Metres, in the
// room.

#include <array>
#include <cstddef>
#include <cstdint>

#include "common/math.h"

namespace prosector {

/// Gesture of a hand, as a glove reports it. Journals and peers store these numbers: append new gestures at
/// the end.
enum class Gesture : std::uint8_t {
  none,
  fist,
  point,
  two,
  three,
  little,
  index_little,
  flat,
  pinch,
  thumb_up,
  thumb_index,
  four
};

inline constexpr std::size_t fingers = 5;  // thumb, index, middle, ring, little

/// Bit of HandPose::buttons that means: the hand cuts by drawing, from the button press until its blade is
/// out of the tissue. The lower bits are device buttons.
inline constexpr std::uint32_t draws_cut = 1u << 31;

struct HandPose {
  bool tracked = false;  // false: no pose in this sample; the server keeps the last pose for a while
  Pose pose;             // wrist in the room frame: −z towards the fingers, +y out of the back of the hand
  std::array<double, fingers> flexion{};  // 0 open … 1 closed fist, thumb first
  Gesture gesture = Gesture::none;
  std::uint32_t buttons = 0;  // one bit per button, and draws_cut
};

/// Tracked object that a user holds in a hand: a tablet or a stylus.
enum class HeldObject : std::uint8_t {
  tablet,  // the user's panel; pose at the board's centre: +x right, +y up, +z towards the reader
  stylus   // pose at the tip, +z along the shaft
};
inline constexpr std::size_t held_things = 2;

struct HeldPose {
  bool tracked = false;
  Pose pose;  // room frame
};

}  // namespace prosector
