#pragma once
// Motion of a panel's controls under fingers within one tick. Buttons and knob are rigid bodies with one
// degree of freedom. A spring returns a button (btGeneric6DofSpring2Constraint). Dry friction holds the knob
// (btSliderConstraint with a motor of speed 0 and bounded force). Fingers are kinematic. Bullet's sequential
// impulses solve the system (projected Gauss–Seidel on the linear complementarity problem).
//
// A pure function: the Bullet world is created for the tick and discarded after it, so a checkpoint needs no
// cached data.

#include <array>
#include <bitset>
#include <span>

#include "common/hand_pose.h"
#include "common/panel.h"

namespace prosector::panel {

/// Shape of a finger segment: the convex hull of two balls of equal radius.
struct Capsule {
  Vec3 a = Vec3::Zero(), b = Vec3::Zero();  // m, the balls' centres
  double radius = 0;                        // m
};

/// Motion of a finger segment in one tick: its shape at the tick's start and end, in the panel's frame.
struct FingerSweep {
  Capsule from, to;
};

/// State of one of a panel's controls (a button or the slider): position and velocity of its cap.
struct ControlMotion {
  double position = 0;  // fraction of its travel, 0 … 1; buttons: 0 at rest
  double velocity = 0;  // of the cap, m/s, positive for increasing position
};
using ControlMotions = std::array<ControlMotion, panel_control_count>;

/// Result of move_controls(): the new state of all controls of a panel, and which of them a finger touched.
struct MovedControls {
  ControlMotions motions;
  std::bitset<panel_control_count> touched;  // by a finger, during the tick
};

/// Moves a panel's buttons and slider through a tick of `h` s under the fingers, whose sweeps are in the
/// panel's frame. Returns the new positions and velocities, and which controls were touched.
///
/// Positions stay within 0 … 1 and speeds below `max_control_speed` for any finger motion. A finger segment
/// that moves more than `max_finger_way` in the tick is treated as a jump: it acts at its end position with
/// zero speed. The board stops fingers. A finger that passed through it presses as if it lay on it, until it
/// is `finger_depth` behind it.
MovedControls move_controls(const ControlMotions& before, std::span<const FingerSweep> fingers, double h);

inline constexpr double button_stiffness = 400;  // N/m: 2.8 N when fully pressed
inline constexpr double max_control_speed = 5;   // m/s
inline constexpr double max_finger_way = 0.15;   // m per tick
inline constexpr double finger_depth = 0.06;     // m

// m: tolerance below the board's surface for segments outside its outline.
inline constexpr double graze = 0.01;

/// Returns whether the finger segment, in the panel's frame, is so close to the panel's board that it may
/// touch the board or its controls.
bool near_panel(const Capsule& finger);

/// Position of a finger segment relative to a panel's board. `over`: above all controls, or not close enough
/// to matter. `under`: over the board's area, but lower than the highest control. `beside`: lower than the
/// board's surface and outside its outline.
enum class AtBoard { over, under, beside };
AtBoard at_board(const Capsule& finger);

}  // namespace prosector::panel
