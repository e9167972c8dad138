#include "client/view/avatar_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "common/anatomy/isosurface.h"
#include "common/ids.h"
#include "common/rotation_between.h"

namespace prosector {
namespace {

constexpr double head_cell = 0.013, bust_cell = 0.026;  // m, approximate edge length of the triangles
constexpr double most_wrist_bend = 0.6;                 // rad
const Vec3 neck_top{0, -0.09, 0.1};                     // m, from the eyes: the head rotates about it
const Vec3 right_shoulder{0.17, -0.27, 0.1};            // m, from the eyes

/// Returns the approximate distance to an ellipsoid.
double ellipsoid(const Vec3& x, const Vec3& center, const Vec3& radii) {
  const Vec3 scaled = (x - center).cwiseQuotient(radii);
  const double k = scaled.norm(), slope = scaled.cwiseQuotient(radii).norm();
  return slope > 1e-9 ? k * (k - 1) / slope : -radii.minCoeff();
}

double capsule(const Vec3& x, const Vec3& a, const Vec3& b, double radius) {
  const Vec3 along = b - a;
  const double t = std::clamp((x - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (x - a - t * along).norm() - radius;
}

/// Returns the smooth minimum; its edge is rounded over a band of `blend` metres.
double blended(double a, double b, double blend) {
  const double overlap = std::max(blend - std::abs(a - b), 0.0);
  return std::min(a, b) - overlap * overlap / (4 * blend);
}

double head_field(const Vec3& at) {
  const Vec3 x(std::abs(at.x()), at.y(), at.z());                                     // the head is symmetric
  double d = ellipsoid(x, {0, 0.035, 0.095}, {0.077, 0.088, 0.094});                  // skull
  d = blended(d, ellipsoid(x, {0, -0.035, 0.045}, {0.063, 0.08, 0.055}), 0.03);       // face
  d = blended(d, ellipsoid(x, {0, -0.09, 0.035}, {0.04, 0.028, 0.04}), 0.03);         // chin
  d = blended(d, capsule(x, {0, 0.02, -0.006}, {0.03, 0.018, 0.002}, 0.008), 0.012);  // brow
  d = blended(d, capsule(x, {0, -0.002, -0.012}, {0, -0.036, -0.03}, 0.008), 0.012);  // nose
  d = blended(d, capsule(x, {0, -0.068, -0.004}, {0.016, -0.068, 0}, 0.006), 0.008);  // mouth
  d = blended(d, ellipsoid(x, {0.076, -0.01, 0.095}, {0.009, 0.03, 0.018}), 0.008);   // ears
  return blended(d, capsule(x, {0, -0.05, 0.095}, neck_top, 0.052), 0.03);            // nape
}

/// Returns the field of a cap on the skull, from the forehead to lower behind.
double cap_field(const Vec3& x) {
  return std::max(head_field(x) - 0.006, 0.062 - 0.3 * x.z() - x.y());
}

/// Returns the field of a mask over nose and mouth.
double mask_field(const Vec3& x) {
  return std::max({head_field(x) - 0.005, x.y() + 0.016, -0.112 - x.y(), x.z() - 0.05});
}

double bust_field(const Vec3& at) {
  const Vec3 x(std::abs(at.x()), at.y(), at.z());
  double d = capsule(x, {0, -0.25, 0.105}, right_shoulder, 0.062);
  d = blended(d, ellipsoid(x, {0, -0.4, 0.105}, {0.185, 0.23, 0.115}), 0.06);
  d = blended(d, capsule(x, right_shoulder, {0.205, -0.46, 0.11}, 0.05), 0.03);  // upper arms
  d = blended(d, capsule(x, {0, -0.13, 0.105}, {0, -0.24, 0.105}, 0.05), 0.04);  // neck, in its collar
  return -blended(-d, x.y() + 0.47, 0.02);                                       // ends below the chest
}

/// Makes a surface of revolution about z from (z, radius) pairs, starting at the wrist; stretched in x by the
/// factor `width`.
TriangleMesh turned(std::span<const std::array<double, 2>> profile, double width) {
  constexpr std::uint32_t sides = 24;
  TriangleMesh out;
  for (const auto& [z, radius] : profile)
    for (std::uint32_t k = 0; k < sides; ++k) {
      const double angle = 2 * std::numbers::pi * k / sides;
      out.positions.emplace_back(width * radius * std::cos(angle), radius * std::sin(angle), z);
    }
  const auto rings = static_cast<std::uint32_t>(profile.size());
  for (std::uint32_t ring = 0; ring + 1 < rings; ++ring)
    for (std::uint32_t k = 0; k < sides; ++k) {
      const std::uint32_t a = ring * sides + k, b = ring * sides + (k + 1) % sides;
      out.triangles.push_back({a, b, b + sides});
      out.triangles.push_back({a, b + sides, a + sides});
    }
  for (const std::uint32_t ring : {0U, rings - 1}) {
    const auto middle = static_cast<std::uint32_t>(out.positions.size());
    out.positions.emplace_back(0, 0, profile[ring][0]);
    for (std::uint32_t k = 0; k < sides; ++k) {
      const std::uint32_t a = ring * sides + k, b = ring * sides + (k + 1) % sides;
      out.triangles.push_back(ring == 0 ? std::array{middle, b, a} : std::array{middle, a, b});
    }
  }
  return out;
}

TriangleMesh forearm() {
  constexpr std::array<std::array<double, 2>, 9> profile = {{{0.048, 0.030},
                                                             {0.048, 0.036},
                                                             {0.052, 0.038},
                                                             {0.080, 0.039},
                                                             {0.083, 0.034},
                                                             {0.16, 0.040},
                                                             {0.23, 0.043},
                                                             {0.27, 0.038},
                                                             {0.285, 0.022}}};
  return turned(profile, 1.15);
}

}  // namespace

FigureSurfaces make_figure_surfaces() {
  return {isosurface({head_field, {{-0.11, -0.18, -0.06}, {0.11, 0.15, 0.22}}}, head_cell),
          isosurface({cap_field, {{-0.11, -0.06, -0.06}, {0.11, 0.15, 0.22}}}, head_cell),
          isosurface({mask_field, {{-0.11, -0.15, -0.07}, {0.11, 0.01, 0.08}}}, head_cell),
          isosurface({bust_field, {{-0.31, -0.52, -0.05}, {0.31, -0.05, 0.26}}}, bust_cell), forearm()};
}

Pose bust_below(const Pose& head) {
  const Vec3 back = head.q * Vec3::UnitZ(), up = head.q * Vec3::UnitY();
  // For a view straight down or up, the crown's or chin's direction defines the heading.
  const Vec3 level = std::hypot(back.x(), back.z()) > 0.3 ? back : back.y() > 0 ? Vec3(-up) : up;
  const Quat upright(Eigen::AngleAxisd(std::atan2(level.x(), level.z()), Vec3::UnitY()));
  return {head * neck_top - upright * neck_top, upright};
}

Pose forearm_behind(const Pose& wrist, const Pose& bust, std::size_t hand) {
  Vec3 shoulder = right_shoulder;
  if (hand == left_hand) shoulder.x() = -shoulder.x();
  const Vec3 way = wrist.q.conjugate() * (bust * shoulder - wrist.p);
  if (!(way.norm() > 1e-6)) return wrist;
  const Quat straight = rotation_between(Vec3::UnitZ(), way.normalized());
  const double angle = straight.angularDistance(Quat::Identity());
  const double share = angle > most_wrist_bend ? most_wrist_bend / angle : 1;
  return {wrist.p, wrist.q * Quat::Identity().slerp(share, straight)};
}

}  // namespace prosector
