#include "client/xr/hand_joints.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/hand.h"
#include "common/ids.h"

namespace prosector {
namespace {

constexpr std::size_t wrist_joint = 1, first_thumb_joint = 2, first_finger_joint = 6, joints_of_finger = 5;
constexpr double quarter_turn = std::numbers::pi / 2;

/// Returns the angle by which the next bone is bent towards the palm, rad.
double bend(const Pose& bone, const Pose& next) {
  const Vec3 ahead = bone.q.conjugate() * (next.q * -Vec3::UnitZ());
  return std::atan2(-ahead.y(), -ahead.z());
}

/// Returns the flexion of the bones that begin at joint `first`, 0 … 1.
double flexion(const HeadsetJoints& joints, std::size_t first, std::span<const double> weights) {
  double sum = 0, squares = 0;
  for (std::size_t k = 0; k < weights.size(); ++k) {
    sum += weights[k] * bend(joints[first + k], joints[first + k + 1]);
    squares += weights[k] * weights[k];
  }
  return std::clamp(sum / (quarter_turn * squares), 0.0, 1.0);
}

/// Returns a controller's grip pose in the wrist frame.
Pose grip_in_wrist(std::size_t hand) {
  const Palm palm = hand_palm(hand);
  const double side = hand == right_hand ? 1 : -1;
  Mat3 axes;  // axes of the grip
  axes << side * Vec3::UnitY(), Vec3::UnitZ(), side * Vec3::UnitX();
  return {palm.center - palm.half_extents.y() * Vec3::UnitY(), Quat(axes)};
}

}  // namespace

std::optional<TrackedHand> hand_of_joints(const HeadsetJoints& joints) {
  if (!std::ranges::all_of(joints, [](const Pose& joint) { return is_finite(joint); })) return std::nullopt;
  constexpr std::array<double, 3> finger_weights = {1, 1, 2.0 / 3};
  constexpr std::array<double, 2> thumb_weights = {1, 1};
  TrackedHand out;
  out.wrist = joints[wrist_joint];
  out.flexion[0] = flexion(joints, first_thumb_joint, thumb_weights);
  for (std::size_t finger = 1; finger < fingers; ++finger)
    out.flexion[finger] =
        flexion(joints, first_finger_joint + joints_of_finger * (finger - 1), finger_weights);
  return out;
}

std::optional<TrackedHand> hand_of_controller(std::size_t hand, const ControllerState& state) {
  if (!is_finite(state.grip) || !std::isfinite(state.trigger) || !std::isfinite(state.squeeze))
    return std::nullopt;
  TrackedHand out;
  out.wrist = state.grip * grip_in_wrist(hand).inverse();
  out.flexion.fill(std::clamp(std::max(state.trigger, state.squeeze), 0.0, 1.0));
  out.flexion[1] = std::clamp(state.trigger, 0.0, 1.0);
  return out;
}

}  // namespace prosector
