#pragma once
// Kinematics of the PHANTOM Omni: joint angles, stylus pose and motor torques.
//
// Frame: x right, y up, z towards the user, origin near the middle of the workspace; metres. Both bars are
// 133.35 mm long. docs/look-up/devices.md names the public sources:
//   x = sin θ1·r,  y = L·(sin θ2 − cos θ3) + 23.35 mm,  z = cos θ1·r − 168.35 mm,
//   with r = L·(cos θ2 + sin θ3).
// θ1 turns the arm to the right, as its encoder counts; OpenHaptics gives it with the opposite sign.
// θ2 and θ3 are absolute angles of the upper and the lower bar in the arm's vertical plane. A parallelogram
// drives the lower bar from the base, so its encoder and its motor act on θ3, not on the elbow angle θ3 − θ2.

#include <array>

#include "common/math.h"

namespace prosector::omni {

using Joints = Vec3;  // rad: θ1 about the vertical, θ2 of the upper bar, θ3 of the lower bar

inline constexpr double bar = 0.13335;                  // m: L
inline constexpr double counts_a_turn = 15000;          // of each joint's encoder
inline const Joints docked(0, 0.23, -0.37);             // with the stylus in its inkwell
inline constexpr double torque_of_full_command = 0.44;  // N·m: 3.3 N on one bar; no public source says it

/// Returns the position of the gimbal's centre, which is the stylus' point, m.
Vec3 tip(const Joints& joints);
/// Returns ∂tip/∂joints, m/rad.
Mat3 jacobian(const Joints& joints);
/// Returns the stylus' orientation in the arm's frame; −z towards its tip. `gimbal`: rad, about the lower
/// bar, then about the axis across the stylus, then about the stylus. The gimbal hangs on the lower bar, so
/// it turns with θ1 and θ3.
Quat orientation(const Joints& joints, const Vec3& gimbal);

/// Returns joints from the encoder counts since the stylus was docked.
Joints joints_of(const std::array<int, 3>& counts);

/// Returns the share of full command for each motor, −1 … 1, that makes the force (N, arm's frame) at the
/// tip: τ = Jᵀf. If one motor would need more, all three are scaled down, so that the force keeps its
/// direction.
Vec3 commands_for(const Joints& joints, const Vec3& force);

}  // namespace prosector::omni
