#pragma once
// A PHANTOM Omni's geometry: joint angles, the stylus' pose, and motors' torques.
//
// Frame: x right, y up, z towards the user, origin near the middle of its workspace; metres. Two bars of
// 133.35 mm, as public drivers have them (docs/do/arms.md says what is known of it, and from where):
//   x = −sin θ1·r,  y = L·(sin θ2 − cos θ3) + 23.35 mm,  z = cos θ1·r − 168.35 mm,  r = L·(cos θ2 + sin θ3)

#include <array>
#include <optional>

#include "common/math.h"

namespace prosector::omni {

using Joints = Vec3;  // rad: θ1 about the vertical, θ2 of the upper bar, θ3 of the lower one

inline constexpr double bar = 0.13335;                  // m: L
inline constexpr double counts_a_turn = 15000;          // of each joint's encoder
inline const Joints docked(0, 0.23, -0.37);             // with the stylus in its inkwell
inline constexpr double torque_of_full_command = 0.44;  // N·m: 3.3 N on one bar; no public source says it

/// Returns where the tip is, m.
Vec3 tip(const Joints& joints);
/// Returns the joints that reach a place; nothing: it is out of reach.
std::optional<Joints> joints_at(const Vec3& tip);
/// Returns ∂tip/∂joints, m/rad.
Mat3 jacobian(const Joints& joints);
/// Returns the stylus' orientation in the arm's frame; −z towards its tip. `gimbal`: rad, about its three
/// axes.
Quat orientation(const Joints& joints, const Vec3& gimbal);

/// Returns joints from encoders' counts since it was docked.
Joints joints_of(const std::array<int, 3>& counts);
/// Returns the counts that are nearest to those joints.
std::array<int, 3> counts_of(const Joints& joints);

/// Returns the share of full command for each motor, −1 … 1, that makes the force (N, arm's frame) at the
/// tip: τ = Jᵀf. Where one would need more, all get less, so that the force keeps its direction.
Vec3 commands_for(const Joints& joints, const Vec3& force);
/// Returns the force at the tip that commands make, N.
Vec3 force_of(const Joints& joints, const Vec3& commands);

}  // namespace prosector::omni
