#include "client/view/hand_nails.h"

#include <cmath>
#include <numbers>

namespace prosector {
namespace {

// A nail is the upper part of a flat ball. Lengths are in radii of the fingertip.
constexpr double half_width = 0.62, half_height = 0.42, half_length = 0.78;
constexpr double over_bone = 0.62;   // of the ball's middle
constexpr double behind_tip = 0.05;  // of the ball's middle, behind the bone's end
constexpr std::uint32_t nail_around = 14, nail_rings = 5;
constexpr std::uint32_t nail_points = nail_around * nail_rings + 1;  // of a nail

/// Returns the outermost joint of a finger.
constexpr std::size_t last_joint(std::size_t finger) {
  return finger == 0 ? 1 : 1 + 3 * finger;
}

/// Returns point k of the unit ball's upper half: its top, then ring after ring down to its rim.
Vec3 on_ball(std::uint32_t k) {
  if (k == 0) return Vec3::UnitY();
  const double down = std::numbers::pi / 2 * ((k - 1) / nail_around + 1) / nail_rings;
  const double turn = 2 * std::numbers::pi * ((k - 1) % nail_around) / nail_around;
  return {std::sin(down) * std::sin(turn), std::cos(down), std::sin(down) * std::cos(turn)};
}

void add_triangles(std::uint32_t first, Triangles& triangles) {
  const auto point = [&](std::uint32_t ring, std::uint32_t k) {
    return first + 1 + ring * nail_around + k % nail_around;
  };
  for (std::uint32_t k = 0; k < nail_around; ++k) {
    triangles.push_back({first, point(0, k), point(0, k + 1)});
    for (std::uint32_t ring = 0; ring + 1 < nail_rings; ++ring) {
      triangles.push_back({point(ring, k), point(ring + 1, k), point(ring + 1, k + 1)});
      triangles.push_back({point(ring, k), point(ring + 1, k + 1), point(ring, k + 1)});
    }
  }
}

}  // namespace

std::shared_ptr<DrawMesh> make_nails(std::size_t hand, std::uint64_t mesh_id) {
  auto out = std::make_shared<DrawMesh>();
  out->id = mesh_id;
  out->positions.resize(fingers * nail_points);
  out->normals.resize(out->positions.size());
  for (std::uint32_t finger = 0; finger < fingers; ++finger)
    add_triangles(finger * nail_points, out->triangles);
  bend_nails(hand, {}, *out);
  out->rest_positions = out->positions;
  return out;
}

void bend_nails(std::size_t hand, const std::array<double, fingers>& flexion, DrawMesh& nails) {
  const std::array<Pose, hand_joints> joints = hand_pose(hand, flexion);
  for (std::size_t finger = 0; finger < fingers; ++finger) {
    const HandSegment& tip = hand_segments(hand)[last_joint(finger)];
    const Pose& joint = joints[last_joint(finger)];
    const Vec3 middle(0, over_bone * tip.radius, -tip.length + behind_tip * tip.radius);
    const Vec3 half = tip.radius * Vec3(half_width, half_height, half_length);
    for (std::uint32_t k = 0; k < nail_points; ++k) {
      const Vec3 unit = on_ball(k);
      nails.positions[finger * nail_points + k] =
          (joint * (middle + half.cwiseProduct(unit)).eval()).cast<float>();
      nails.normals[finger * nail_points + k] =
          (joint.q * unit.cwiseQuotient(half).normalized()).cast<float>();
    }
  }
  ++nails.positions_revision;
}

Appearance nail_look(const Appearance& hand) {
  return {.color = 0.6 * hand.color + 0.4 * Vec3(0.80, 0.66, 0.62), .roughness = 0.25};
}

}  // namespace prosector
