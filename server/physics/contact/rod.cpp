#include "server/physics/contact/rod.h"

#include <algorithm>

#include "server/physics/contact/grid_distance.h"

namespace prosector {
namespace {

struct Parameters {
  double s, t;  // along the first and the second segment
};

/// Closest points of segments p + s·d and q + t·e, s and t in [0, 1] (Ericson, 5.1.9).
Parameters closest_parameters(const Vec3& p, const Vec3& d, const Vec3& q, const Vec3& e) {
  const Vec3 r = p - q;
  const double a = d.squaredNorm(), b = d.dot(e), c = d.dot(r), f = e.dot(r), ee = e.squaredNorm();
  if (!(ee > 0)) return {a > 0 ? std::clamp(-c / a, 0.0, 1.0) : 0, 0};
  if (!(a > 0)) return {0, std::clamp(f / ee, 0.0, 1.0)};
  const double denominator = a * ee - b * b;
  double s = denominator > 0 ? std::clamp((b * f - c * ee) / denominator, 0.0, 1.0) : 0;
  double t = (b * s + f) / ee;
  if (t < 0 || t > 1) {
    t = std::clamp(t, 0.0, 1.0);
    s = std::clamp((b * t - c) / a, 0.0, 1.0);
  }
  return {s, t};
}

std::optional<SegmentTriangle> crossing(const Vec3& from, const Vec3& to,
                                        const std::array<Vec3, 3>& triangle) {
  const Vec3 normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
  const double at_from = normal.dot(from - triangle[0]), at_to = normal.dot(to - triangle[0]);
  if (at_from * at_to >= 0) return std::nullopt;
  SegmentTriangle out;
  out.on_segment = from + at_from / (at_from - at_to) * (to - from);
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 &b = triangle[(k + 1) % 3], &c = triangle[(k + 2) % 3];
    out.weights[static_cast<Eigen::Index>(k)] =
        (b - out.on_segment).cross(c - out.on_segment).dot(normal) / normal.squaredNorm();
  }
  if (out.weights.minCoeff() < 0) return std::nullopt;
  return out;
}

}  // namespace

std::optional<Rod> rod_of(const ShapePart& part, const Pose& pose) {
  Rod out;
  double half = 0;
  out.radius = part.half.x();
  if (part.kind == ShapeKind::capsule) {
    half = part.half.y();
  } else if (part.kind == ShapeKind::cylinder) {
    out.radius = std::min(part.half.x(), part.half.y());
    half = part.half.y() - out.radius;
  } else if (part.kind != ShapeKind::sphere) {
    return std::nullopt;
  }
  out.from = pose * Vec3(0, -half, 0);
  out.to = pose * Vec3(0, half, 0);
  out.lo = out.from.cwiseMin(out.to).array() - out.radius;
  out.hi = out.from.cwiseMax(out.to).array() + out.radius;
  return out;
}

SegmentTriangle closest(const Vec3& from, const Vec3& to, const std::array<Vec3, 3>& triangle) {
  if (const auto through = crossing(from, to, triangle)) return *through;
  SegmentTriangle best;
  best.distance = -1;
  const auto offer = [&](const Vec3& on_segment, const Vec3& weights) {
    const Vec3 point = weights[0] * triangle[0] + weights[1] * triangle[1] + weights[2] * triangle[2];
    const double distance = (point - on_segment).norm();
    if (best.distance < 0 || distance < best.distance) best = {weights, on_segment, distance};
  };
  for (const Vec3& end : {from, to}) offer(end, closest_weights(end, triangle[0], triangle[1], triangle[2]));
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const auto [s, t] = closest_parameters(from, to - from, triangle[k], triangle[next] - triangle[k]);
    Vec3 weights = Vec3::Zero();
    weights[static_cast<Eigen::Index>(k)] = 1 - t;
    weights[static_cast<Eigen::Index>(next)] = t;
    offer(from + s * (to - from), weights);
  }
  return best;
}

}  // namespace prosector
