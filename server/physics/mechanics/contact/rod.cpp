#include "server/physics/mechanics/contact/rod.h"

#include <algorithm>

#include "server/physics/mechanics/collision/primitives/closest_points.h"

namespace prosector::contact {
namespace {

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

std::optional<Rod> rod_of(const collision::ShapePart& part, const Pose& pose) {
  Rod out;
  double half = 0;
  out.radius = part.half.x();
  if (part.kind == collision::ShapeKind::capsule) {
    half = part.half.y();
  } else if (part.kind == collision::ShapeKind::cylinder) {
    out.radius = std::min(part.half.x(), part.half.y());
    half = part.half.y() - out.radius;
  } else if (part.kind != collision::ShapeKind::sphere) {
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
  for (const Vec3& end : {from, to})
    offer(end, collision::closest_weights(end, triangle[0], triangle[1], triangle[2]));
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const auto [s, t] =
        collision::closest_parameters(from, to - from, triangle[k], triangle[next] - triangle[k]);
    Vec3 weights = Vec3::Zero();
    weights[static_cast<Eigen::Index>(k)] = 1 - t;
    weights[static_cast<Eigen::Index>(next)] = t;
    offer(from + s * (to - from), weights);
  }
  return best;
}

}  // namespace prosector::contact
