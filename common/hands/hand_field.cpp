#include "common/hands/hand_field.h"
#include "common/ids.h"

#include <algorithm>
#include <cmath>

namespace prosector {
namespace {

/// A bone with flesh: a capsule whose radius varies linearly along its length.
struct Limb {
  Vec3 a, b;
  double radius_a, radius_b;

  double distance(const Vec3& x) const {
    const Vec3 along = b - a;
    const double t = std::clamp((x - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
    return (x - a - t * along).norm() - (radius_a + t * (radius_b - radius_a));
  }
};

// Radius of the skin relative to the physical hand's capsules: slightly larger, so that contact looks firm.
constexpr double flesh = 1.04;

/// Returns the minimum of two distances, blended smoothly over a band of `blend` metres.
double smooth_min(double a, double b, double blend) {
  const double overlap = std::max(blend - std::abs(a - b), 0.0);
  return std::min(a, b) - overlap * overlap / (4 * blend);
}

std::size_t finger_of(std::size_t segment) {
  return segment < 2 ? 0 : 1 + (segment - 2) / 3;
}

std::array<Limb, hand_joints> phalanges() {
  const std::array<Pose, hand_joints> open = hand_pose(right_hand, {});
  std::array<Limb, hand_joints> out;
  for (const HandSegment& s : hand_segments(right_hand)) {
    const bool is_tip = s.joint == 1 || (s.joint >= 2 && (s.joint - 2) % 3 == 2);
    // A capsule extends one radius beyond its ends. The fingertip's capsule is shortened by 0.6 radii, so
    // that the skin ends near the bone's end.
    const double end_radius = flesh * s.radius * (is_tip ? 0.80 : 0.92);
    const Vec3 end(0, 0, -(s.length - (is_tip ? 0.6 * end_radius : 0)));
    out[s.joint] = {open[s.joint].p, open[s.joint] * end, flesh * s.radius, end_radius};
  }
  return out;
}

/// Returns capsules of the palm: the metacarpal bones from the wrist to each knuckle, and the thenar and
/// hypothenar eminences.
std::array<Limb, 6> palm_limbs() {
  const auto& segments = hand_segments(right_hand);
  std::array<Limb, 6> out;
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec3 knuckle = segments[2 + 3 * k].origin;
    out[k] = {{0.45 * knuckle.x(), -0.001, -0.012}, knuckle, 0.0125, 0.0095};
  }
  out[4] = {{-0.012, -0.007, -0.012}, segments[0].origin, 0.0140, 0.0125};
  out[5] = {{0.017, -0.007, -0.016}, {0.029, -0.005, -0.062}, 0.0125, 0.0105};
  return out;
}

double wrist(const Vec3& x) {
  static const Limb round{{0, 0, 0.090}, {0, 0, -0.012}, 0.0195, 0.0175};
  const Vec3 squeezed(x.x() * 0.70, x.y(), x.z());  // wider than thick
  const double cut = x.z() - 0.055;                 // end of the forearm
  return -smooth_min(-round.distance(squeezed), -cut, 0.008);
}

/// Returns the distance to the flesh between the metacarpals: a rounded box inside the physical palm.
double slab(const Vec3& x) {
  const Palm palm = hand_palm(right_hand);
  constexpr double rounding = 0.007;
  const Vec3 core = palm.half_extents - Vec3(0.008, 0.001, 0.015) - Vec3::Constant(rounding);
  const Vec3 center = palm.center - Vec3(0, 0, 0.012);  // the wrist is narrower
  const Vec3 beyond = (x - center).cwiseAbs() - core;
  return beyond.cwiseMax(0).norm() + std::min(beyond.maxCoeff(), 0.0) - rounding;
}

}  // namespace

HandField hand_field(const Vec3& at) {
  static const auto fingers_limbs = phalanges();
  static const auto palm = palm_limbs();

  double body = smooth_min(wrist(at), slab(at), 0.012);
  for (const Limb& limb : palm) body = smooth_min(body, limb.distance(at), 0.012);

  HandField out;
  out.finger.fill(1);
  for (std::size_t k = 0; k < hand_joints; ++k) {
    double& finger = out.finger[finger_of(k)];
    finger = smooth_min(finger, fingers_limbs[k].distance(at), 0.0008);
  }
  // Each finger blends into the palm, but not into its neighbours.
  out.solid = body;
  for (const double finger : out.finger) out.solid = std::min(out.solid, smooth_min(body, finger, 0.010));
  return out;
}

}  // namespace prosector
