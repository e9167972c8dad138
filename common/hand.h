#pragma once
// The hand that five bend sensors drive: 14 joints, shared by the server (physical hand) and the client
// (drawn hand).
//
// A bend sensor reports x in [0, 1] with x = c₁·MCP + c₄·PIP and c₁·MCP = 2·c₄·PIP, c₁ = 2/3, c₄ = 1/3, so
// MCP = PIP = x. MCP, PIP and IP in [0, 1] map linearly to 0–90°, DIP = 2/3·PIP, and x = 1 is a closed fist.
// The thumb has MCP and IP.

#include <array>

#include "common/math.h"
#include "common/messages.h"

namespace prosector {

inline constexpr std::size_t hand_joints =
    14;  // thumb MCP, IP; then MCP, PIP, DIP of index, middle, ring, little

/// One bone segment: a capsule from its joint along its local −z, in metres.
struct HandSegment {
  std::size_t joint;  // the joint that moves it
  int parent;         // segment before it, −1: the palm
  Vec3 origin;        // joint's place in its parent segment's frame (or the wrist's)
  Quat rest;          // orientation at 0° in its parent's frame
  double length;      // m
  double radius;      // m
};

/// Returns joint angles in radians from the five flexions (values outside [0, 1] are clamped).
std::array<double, hand_joints> joint_angles(const std::array<double, fingers>& flexion);

/// Returns the right (1) or left (0) hand's segments in joint order; the left is the right's mirror image in
/// x.
const std::array<HandSegment, hand_joints>& hand_segments(std::size_t hand);

/// The palm as a box: half extents and its centre in the wrist frame.
struct Palm {
  Vec3 center;
  Vec3 half_extents;
};
Palm hand_palm(std::size_t hand);

/// Returns the pose of every segment's frame in the wrist's frame, joint order.
std::array<Pose, hand_joints> hand_pose(std::size_t hand, const std::array<double, fingers>& flexion);

/// Returns the tip of the middle finger in the wrist's frame, m.
Vec3 middle_fingertip(std::size_t hand, const std::array<double, fingers>& flexion);

}  // namespace prosector
