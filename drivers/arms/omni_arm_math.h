#pragma once
// Kinematics of the PHANTOM Omni: joint angles, stylus pose and motor torques.
//
// Frame: x right, y up, z towards the user, origin near the middle of the workspace; metres. Both bars are
// 133.35 mm long. docs/look-up/devices.md names the public sources:
//   x = sin θ1·r,  y = L·(sin θ2 − cos θ3) + 23.35 mm,  z = cos θ1·r − 168.35 mm,
//   with r = L·(cos θ2 + sin θ3).
// θ1 rotates the arm to the right, in the direction in which its encoder counts; OpenHaptics reports it with
// the opposite sign. θ2 and θ3 are absolute angles of the upper and the lower bar in the arm's vertical
// plane. A parallelogram drives the lower bar from the base. Its encoder and its motor therefore act on θ3,
// not on the elbow angle θ3 − θ2.

#include <array>

#include "common/math.h"

namespace prosector::omni {

using Joints = Vec3;  // rad: θ1 about the vertical, θ2 of the upper bar, θ3 of the lower bar

inline constexpr double bar = 0.13335;               // m: L
inline constexpr double counts_a_turn = 15000;       // of each joint's encoder, per revolution
inline const Joints docked(0, 0.23, -0.37);          // joint angles with the stylus in its inkwell
inline constexpr double full_command_torque = 0.44;  // N·m: 3.3 N at one bar's length; no public source
                                                     // states it

/// Returns the position of the stylus origin, which is the centre of the Omni's gimbal, for the given joint
/// angles (rad); m, arm frame.
Vec3 tip(const Joints& joints);
/// Returns the derivatives of the stylus origin's position (rows: x, y, z, arm frame) with respect to the
/// three joint angles (columns), m/rad.
Mat3 jacobian(const Joints& joints);
/// Returns the stylus orientation in the arm frame; −z points towards the stylus tip. The angles of `gimbal`
/// (rad) are about the lower bar, then about the axis across the stylus, then about the stylus. The gimbal is
/// mounted on the lower bar, so it rotates with the joint angles θ1 and θ3.
Quat orientation(const Joints& joints, const Vec3& gimbal);

/// Computes the Omni's joint angles (rad) from the encoder counts relative to those with the stylus in its
/// inkwell.
Joints joints_of(const std::array<int, 3>& counts);

/// Computes the commands of the Omni's three motors for a force (N, arm frame) at the stylus origin, τ = Jᵀf.
/// Commands are fractions of full command, −1 … 1. If one motor would exceed full command, all three are
/// scaled down, so that the force keeps its direction.
Vec3 commands_for(const Joints& joints, const Vec3& force);

}  // namespace prosector::omni
