#include "twins/trackers/simulated_wearer.h"
#include "common/ids.h"

namespace prosector {
namespace {

constexpr double metacarpal = 0.06, thumb_metacarpal = 0.03;  // m, bone lengths

/// Adds a finger's joints, from its metacarpal to its tip, to `joints` at index `joint`.
void add_finger(std::array<Pose, joints_per_hand>& joints, std::size_t joint, std::size_t hand,
                std::span<const Pose> bones, std::size_t first_segment, double length_before) {
  const HandSegment& knuckle = hand_segments(hand)[first_segment];
  joints[joint++] = Pose{knuckle.origin, knuckle.rest} * Pose{{0, 0, length_before}, Quat::Identity()};
  for (std::size_t k = 0; k < bones.size(); ++k) joints[joint++] = bones[k];
  const double last = hand_segments(hand)[first_segment + bones.size() - 1].length;
  joints[joint] = bones.back() * Pose{{0, 0, -last}, Quat::Identity()};
}

}  // namespace

std::array<Pose, joints_per_hand> hand_model_joints(std::size_t hand,
                                                    const std::array<double, fingers>& flexion) {
  std::array<Pose, joints_per_hand> out;
  out[0].p = hand_palm(hand).center;  // the palm; joint 1 is the wrist
  const auto bones = hand_pose(hand, flexion);
  const std::span<const Pose> all(bones);
  add_finger(out, 2, hand, all.subspan(0, 2), 0, thumb_metacarpal);
  for (std::size_t finger = 0; finger < 4; ++finger)
    add_finger(out, 6 + 5 * finger, hand, all.subspan(2 + 3 * finger, 3), 2 + 3 * finger, metacarpal);
  return out;
}

Pose SimulatedWearer::grip(std::size_t hand, double time) const {
  // The right hand's +x points from the palm to its back, and −z from the little finger to the thumb. The
  // left hand's +x points the opposite way, and −z also points to the thumb.
  const Palm palm = hand_palm(hand);
  const Quat turn = hand == right_hand ? Quat(0.5, 0.5, 0.5, 0.5) : Quat(0.5, 0.5, -0.5, -0.5);
  return wrist(hand, time) * Pose{palm.center - Vec3(0, palm.half_extents.y(), 0), turn};
}

}  // namespace prosector
