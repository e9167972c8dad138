#pragma once
// How fingers move a panel's controls within one tick. Buttons and knob are rigid bodies that constraints
// leave one direction. A spring returns a button (btGeneric6DofSpring2Constraint); dry friction holds the
// knob (btSliderConstraint with a motor of speed 0 and bounded force). Fingers are kinematic. Bullet's
// sequential impulses (projected Gauss–Seidel on the linear complementarity problem) solve it.
//
// A pure function: the small world is made for the tick from plain numbers and dropped after it, so nothing
// is cached that a checkpoint would have to hold.

#include <array>
#include <bitset>
#include <span>

#include "common/panel.h"

namespace prosector {

/// A finger segment: the hull of two balls.
struct Capsule {
  Vec3 a = Vec3::Zero(), b = Vec3::Zero();  // m, the balls' centres
  double radius = 0;                        // m
};

/// A segment over one tick, in the panel's frame.
struct FingerSweep {
  Capsule from, to;
};

struct ControlMotion {
  double position = 0;  // share of its way, 0 … 1; buttons: 0 at rest
  double velocity = 0;  // of the cap, m/s, in the sense of growing position
};
using ControlMotions = std::array<ControlMotion, panel_control_count>;

struct MovedControls {
  ControlMotions motions;
  std::bitset<panel_control_count> touched;  // by a finger, during the tick
};

/// Moves the controls through a tick of `h` seconds. Whatever the fingers do, positions stay within 0 … 1 and
/// speeds below `max_control_speed`. A segment that moves more than `max_finger_way` in the tick has jumped:
/// it counts where it is, without speed. Fingers stop at the board: one that went through it presses as if it
/// lay on it, until it is `finger_depth` behind.
MovedControls move_controls(const ControlMotions& before, std::span<const FingerSweep> fingers, double h);

inline constexpr double button_stiffness = 400;  // N/m: 2.8 N when pressed home
inline constexpr double max_control_speed = 5;   // m/s
inline constexpr double max_finger_way = 0.15;   // m in a tick
inline constexpr double finger_depth = 0.06;     // m

inline constexpr double graze = 0.01;  // m that a segment may be lower than the board beside it

/// Tells whether the segment may touch the board or what is on it.
bool near_panel(const Capsule& finger);

/// Where a segment is: higher than all controls, lower and at the board, or lower than the board beside it.
enum class AtBoard { over, under, beside };
AtBoard at_board(const Capsule& finger);

}  // namespace prosector
