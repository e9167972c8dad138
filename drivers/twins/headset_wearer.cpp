#include "drivers/twins/headset_wearer.h"

namespace prosector {
namespace {

constexpr double metacarpal = 0.06, thumb_metacarpal = 0.03;  // m

/// Adds the bones of a finger, from its metacarpal on, as joints from `joint` on.
void add_finger(std::array<Pose, worn_joints>& joints, std::size_t joint, std::size_t hand,
                std::span<const Pose> bones, std::size_t first_segment, double length_before) {
  const HandSegment& knuckle = hand_segments(hand)[first_segment];
  joints[joint++] = Pose{knuckle.origin, knuckle.rest} * Pose{{0, 0, length_before}, Quat::Identity()};
  for (std::size_t k = 0; k < bones.size(); ++k) joints[joint++] = bones[k];
  const double last = hand_segments(hand)[first_segment + bones.size() - 1].length;
  joints[joint] = bones.back() * Pose{{0, 0, -last}, Quat::Identity()};
}

}  // namespace

std::array<Pose, worn_joints> seen_joints(std::size_t hand, const std::array<double, fingers>& flexion) {
  std::array<Pose, worn_joints> out;
  out[0].p = hand_palm(hand).center;  // the palm; next is the wrist
  const auto bones = hand_pose(hand, flexion);
  const std::span<const Pose> all(bones);
  add_finger(out, 2, hand, all.subspan(0, 2), 0, thumb_metacarpal);
  for (std::size_t finger = 0; finger < 4; ++finger)
    add_finger(out, 6 + 5 * finger, hand, all.subspan(2 + 3 * finger, 3), 2 + 3 * finger, metacarpal);
  return out;
}

Pose HeadsetWearer::grip(std::size_t hand, double time) const {
  // The right hand's +x goes from the palm to its back, and −z from the little finger to the thumb, on its
  // left. The left hand's go the other way.
  const Palm palm = hand_palm(hand);
  const Quat turn = hand == right_hand ? Quat(0.5, 0.5, 0.5, 0.5) : Quat(0.5, 0.5, -0.5, -0.5);
  return wrist(hand, time) * Pose{palm.center - Vec3(0, palm.half_extents.y(), 0), turn};
}

}  // namespace prosector
