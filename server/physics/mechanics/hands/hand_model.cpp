#include "server/physics/mechanics/hands/hand_model.h"

#include <numbers>

namespace prosector::hands {
namespace {

// m, half extents of the open hand's box.
constexpr double half_length = 0.095, half_width = 0.04, half_thickness = 0.015;

}  // namespace

std::vector<Pose> hand_part_poses(std::size_t hand, const std::array<double, fingers>& flexion,
                                  const Pose& center) {
  const Pose to_center = center.inverse();
  std::vector<Pose> out = {to_center * Pose{hand_palm(hand).center, Quat::Identity()}};
  const auto poses = hand_pose(hand, flexion);
  const Quat along_z(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitX()));  // capsules are along y
  for (const HandSegment& s : hand_segments(hand))
    out.push_back(to_center * poses[s.joint] * Pose{{0, 0, -s.length / 2}, along_z});
  return out;
}

HandModel make_hand_model(std::size_t hand, const HandDesc& desc) {
  HandModel out;
  out.center = {hand_palm(hand).center, Quat::Identity()};
  const auto poses = hand_part_poses(hand, {}, out.center);
  out.shape.parts.push_back({collision::ShapeKind::box, hand_palm(hand).half_extents, poses[0], nullptr});
  for (const HandSegment& s : hand_segments(hand))
    out.shape.parts.push_back(
        {collision::ShapeKind::capsule, {s.radius, s.length / 2, s.radius}, poses[s.joint + 1], nullptr});
  for (const collision::ShapePart& part : out.shape.parts)
    out.shape.distances.push_back(contact::make_signed_distance(part));
  const Vec3 s = Vec3(half_width, half_thickness, half_length).cwiseAbs2();
  out.setup.parts = out.shape.parts;
  out.setup.mass = desc.mass;
  out.setup.inertia = desc.mass / 3 * Vec3(s.y() + s.z(), s.x() + s.z(), s.x() + s.y());
  out.setup.friction = desc.friction;
  out.setup.hand = true;
  return out;
}

}  // namespace prosector::hands
