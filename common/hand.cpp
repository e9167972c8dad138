#include "common/hand.h"
#include "common/ids.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace prosector {
namespace {

constexpr double quarter_turn = std::numbers::pi / 2;

struct FingerShape {
  Vec3 knuckle;                  // right hand, wrist frame, m
  double yaw;                    // rad about +y: spread of the finger
  std::array<double, 3> length;  // m, proximal to distal
  double radius;                 // m, at the proximal segment
};

// An adult hand, 190 mm from wrist to middle fingertip, right hand, palm facing −y: thumb at −x.
const std::array<FingerShape, 4> finger_shapes = {{
    {{-0.026, 0, -0.090}, 0.06, {0.043, 0.025, 0.020}, 0.0085},
    {{-0.005, 0, -0.094}, 0.01, {0.047, 0.029, 0.021}, 0.0088},
    {{0.016, 0, -0.089}, -0.04, {0.043, 0.027, 0.021}, 0.0083},
    {{0.035, 0, -0.080}, -0.12, {0.034, 0.020, 0.019}, 0.0073},
}};

Vec3 mirrored(Vec3 v) {
  v.x() = -v.x();
  return v;
}

// Mirror in x: a rotation's axis is a pseudo-vector, so y and z components flip.
Quat mirrored(const Quat& q) {
  return {q.w(), q.x(), -q.y(), -q.z()};
}

std::array<HandSegment, hand_joints> make_segments(bool left) {
  std::array<HandSegment, hand_joints> out;
  // The thumb starts next to the wrist, points forward and outward, and bends across the palm.
  const Quat thumb = Eigen::AngleAxisd(0.75, Vec3::UnitY()) * Eigen::AngleAxisd(-0.25, Vec3::UnitX()) *
                     Eigen::AngleAxisd(1.0, Vec3::UnitZ());
  out[0] = {0, -1, {-0.032, -0.008, -0.045}, thumb, 0.038, 0.0105};
  out[1] = {1, 0, {0, 0, -0.038}, Quat::Identity(), 0.029, 0.0095};
  std::size_t joint = 2;
  for (const FingerShape& finger : finger_shapes) {
    int parent = -1;
    Vec3 origin = finger.knuckle;
    Quat rest(Eigen::AngleAxisd(finger.yaw, Vec3::UnitY()));
    for (std::size_t k = 0; k < 3; ++k) {
      out[joint] = {joint, parent,           origin,
                    rest,  finger.length[k], finger.radius * (1 - 0.08 * static_cast<double>(k))};
      parent = static_cast<int>(joint++);
      origin = {0, 0, -finger.length[k]};
      rest = Quat::Identity();
    }
  }
  if (left)
    for (HandSegment& s : out) {
      s.origin = mirrored(s.origin);
      s.rest = mirrored(s.rest);
    }
  return out;
}

}  // namespace

std::array<double, hand_joints> joint_angles(const std::array<double, fingers>& flexion) {
  std::array<double, hand_joints> out{};
  const auto bend = [&](std::size_t finger) { return std::clamp(flexion[finger], 0.0, 1.0) * quarter_turn; };
  out[0] = out[1] = bend(0);
  for (std::size_t finger = 1; finger < fingers; ++finger) {
    const std::size_t mcp = 2 + 3 * (finger - 1);
    out[mcp] = out[mcp + 1] = bend(finger);
    out[mcp + 2] = 2.0 / 3.0 * out[mcp + 1];
  }
  return out;
}

const std::array<HandSegment, hand_joints>& hand_segments(std::size_t hand) {
  static const std::array<std::array<HandSegment, hand_joints>, 2> table = {make_segments(true),
                                                                            make_segments(false)};
  return table.at(hand);
}

Palm hand_palm(std::size_t hand) {
  const double side = hand == right_hand ? 1 : -1;
  return {{side * 0.004, 0, -0.045}, {0.038, 0.011, 0.043}};
}

std::array<Pose, hand_joints> hand_pose(std::size_t hand, const std::array<double, fingers>& flexion) {
  const auto& segments = hand_segments(hand);
  const auto angles = joint_angles(flexion);
  std::array<Pose, hand_joints> out;
  for (const HandSegment& s : segments) {
    // Bending rotates a finger towards the palm (−y): about −x for fingers that point along −z.
    const Quat bend(Eigen::AngleAxisd(-angles[s.joint], Vec3::UnitX()));
    const Pose local{s.origin, s.rest * bend};
    out[s.joint] = s.parent < 0 ? local : out[static_cast<std::size_t>(s.parent)] * local;
  }
  return out;
}

Vec3 middle_fingertip(std::size_t hand, const std::array<double, fingers>& flexion) {
  constexpr std::size_t middle_tip = 7;  // joint
  return hand_pose(hand, flexion)[middle_tip] * Vec3(0, 0, -hand_segments(hand)[middle_tip].length);
}

}  // namespace prosector
