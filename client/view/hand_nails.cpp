#include "client/view/hand_nails.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace prosector {
namespace {

// A nail is a thin plate around the back of the fingertip. Lengths are in units of its bone's radius.
constexpr double half_angle = 0.68;              // rad around the bone, from the centre line to each side
constexpr double root = 1.2, free_edge = -0.08;  // from the bone's end, positive towards the hand
// Height of the centre over the skin; depth of the rim below the plate.
constexpr double thickness = 0.05, sunk = 0.06;
constexpr double tip_radius = 0.83;  // of the flesh at the bone's end, a sphere
constexpr double tip_middle = 0.5;   // centre of that sphere, from the bone's end
constexpr double growth = 0.085;     // increase of the flesh's radius per unit of length towards the hand
// In units of the tip's radius: smallest radius to which the plate curves down.
constexpr double overhang = 0.88;
constexpr double corner = 0.65;  // exponent: 1: an ellipse; nearer to 0: a rectangle
constexpr std::uint32_t nail_around = 24, nail_rings = 6;            // the last ring is the rim, in the skin
constexpr std::uint32_t nail_points = nail_around * nail_rings + 1;  // per nail

/// Returns the outermost joint of a finger.
constexpr std::size_t last_joint(std::size_t finger) {
  return finger == 0 ? 1 : 1 + 3 * finger;
}

/// A point of a nail, in the frame of a bone of radius 1 that ends at the origin.
struct NailPoint {
  Vec3 at, normal;
};

/// Returns the distance of the plate's lower side from the bone's axis.
double plate_radius(double z) {
  const double ahead = tip_middle - z;  // of the sphere's centre
  if (ahead < 0) return tip_radius - growth * ahead;
  return std::max(std::sqrt(std::max(tip_radius * tip_radius - ahead * ahead, 0.0)), overhang * tip_radius);
}

/// Returns point k of a nail: its centre, then ring after ring, the rim last.
NailPoint nail_point(std::uint32_t k) {
  const std::uint32_t ring = k == 0 ? 0 : (k - 1) / nail_around + 1;
  const bool rim = ring == nail_rings;
  const double share = std::min(1.0, static_cast<double>(ring) / (nail_rings - 1));
  const double turn =
      2 * std::numbers::pi * static_cast<double>((k + nail_around - 1) % nail_around) / nail_around;
  const auto rounded = [&](double x) { return share * std::copysign(std::pow(std::abs(x), corner), x); };
  const double angle = half_angle * rounded(std::sin(turn));
  const double z = (root + free_edge) / 2 + (root - free_edge) / 2 * rounded(std::cos(turn));
  const Vec3 out(std::sin(angle), std::cos(angle), 0);
  const double lift = thickness * (1 - 0.7 * share * share) - (rim ? sunk : 0);
  const Vec3 at = (plate_radius(z) + lift) * out + z * Vec3::UnitZ();
  const Vec3 aside(std::sin(turn), 0, std::cos(turn));
  return {at, rim ? Vec3((out + aside).normalized()) : out};
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
    const Vec3 end(0, 0, -tip.length);
    for (std::uint32_t k = 0; k < nail_points; ++k) {
      const NailPoint point = nail_point(k);
      nails.positions[finger * nail_points + k] =
          (joint * (end + tip.radius * point.at).eval()).cast<float>();
      nails.normals[finger * nail_points + k] = (joint.q * point.normal).cast<float>();
    }
  }
  ++nails.positions_revision;
}

Appearance nail_look(const Appearance& hand) {
  return {.color = 0.75 * hand.color + 0.25 * Vec3(0.72, 0.50, 0.46), .roughness = 0.4};
}

}  // namespace prosector
