#pragma once
// Kinematic model of a hand driven by five bend sensors: 14 joints. Shared by the server (physical hand) and
// the client (drawn hand).
//
// A bend sensor reports x in [0, 1] with x = c₁·MCP + c₄·PIP and c₁·MCP = 2·c₄·PIP, c₁ = 2/3, c₄ = 1/3, so
// MCP = PIP = x. MCP, PIP and IP in [0, 1] map linearly to 0–90°, DIP = 2/3·PIP, and x = 1 is a closed fist.
// The thumb has MCP and IP.

#include <array>

#include "common/hand_pose.h"
#include "common/math.h"

namespace prosector {

inline constexpr std::size_t hand_joints =
    14;  // thumb MCP, IP; then MCP, PIP, DIP of index, middle, ring, little

/// One bone segment of the hand model: a capsule that extends from its joint along its local −z axis.
struct HandSegment {
  std::size_t joint;  // the joint that moves it
  int parent;         // index of the parent segment; −1: the palm
  Vec3 origin;        // m: joint position in the parent segment's frame (or the wrist's)
  Quat rest;          // orientation at 0° in the parent's frame
  double length;      // m
  double radius;      // m
};

/// Returns the angles (rad) of the hand's joints from the flexions of the five fingers (0 open … 1 closed
/// fist; other values are clamped).
std::array<double, hand_joints> joint_angles(const std::array<double, fingers>& flexion);

/// Returns the bone segments of the right (1) or left (0) hand in joint order. The left hand mirrors the
/// right in x.
const std::array<HandSegment, hand_joints>& hand_segments(std::size_t hand);

/// The palm of the hand model as a box: centre in the wrist frame and half extents, m.
struct Palm {
  Vec3 center;
  Vec3 half_extents;
};
Palm hand_palm(std::size_t hand);

/// Returns the pose of each bone segment's frame in the wrist frame, in joint order, for the given finger
/// flexions.
std::array<Pose, hand_joints> hand_pose(std::size_t hand, const std::array<double, fingers>& flexion);

/// Returns the position of the tip of the middle finger (m, wrist frame) for the given finger flexions.
Vec3 middle_fingertip(std::size_t hand, const std::array<double, fingers>& flexion);

}  // namespace prosector
