#include "server/physics/contact/surface_detector.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace prosector {
namespace {

/// Morton code: 10 bits of each coordinate, interleaved.
std::uint32_t morton(const Vec3& unit) {
  std::uint32_t code = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto cell = static_cast<std::uint32_t>(std::clamp(unit[axis], 0.0, 1.0) * 1023);
    for (int bit = 0; bit < 10; ++bit) code |= (cell >> bit & 1U) << (3 * bit + axis);
  }
  return code;
}

std::vector<std::uint32_t> spatial_order(const std::vector<Vec3>& points) {
  Vec3 lo = Vec3::Constant(std::numeric_limits<double>::max()), hi = -lo;
  for (const Vec3& p : points) {
    lo = lo.cwiseMin(p);
    hi = hi.cwiseMax(p);
  }
  const double extent = points.empty() ? 1 : std::max((hi - lo).maxCoeff(), 1e-9);
  std::vector<std::uint32_t> codes;
  for (const Vec3& p : points) codes.push_back(morton((p - lo) / extent));
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return codes[a] < codes[b]; });
  return order;
}

}  // namespace

SurfaceDetector::SurfaceDetector(const SparseMap& embedding, const TriangleMesh& rest)
    : embedding_(&embedding), order_(spatial_order(rest.positions)), positions_(rest.positions) {
  chunks_.resize((order_.size() + chunk_vertices - 1) / chunk_vertices);
}

void SurfaceDetector::update(const double* x) {
  lo_ = Vec3::Constant(std::numeric_limits<double>::max());
  hi_ = -lo_;
  for (std::size_t c = 0; c < chunks_.size(); ++c) {
    Vec3 lo = Vec3::Constant(std::numeric_limits<double>::max()), hi = -lo;
    for (std::size_t i = c * chunk_vertices; i < chunk_end(c); ++i) {
      const Vec3 p = positions_[order_[i]] = embedding_->apply(order_[i], x);
      lo = lo.cwiseMin(p);
      hi = hi.cwiseMax(p);
    }
    chunks_[c] = {lo, hi};
    lo_ = lo_.cwiseMin(lo);
    hi_ = hi_.cwiseMax(hi);
  }
}

bool SurfaceDetector::touches(const Collider& collider, double margin) const {
  bool found = false;
  near(collider, margin, [&](std::uint32_t, const Distance&) { found = true; });
  return found;
}

Distance distance_to(const Collider& collider, const Vec3& x, double margin) {
  const Vec3 local = collider.pose.q.conjugate() * (x - collider.pose.p);
  Distance best{std::numeric_limits<double>::max(), Vec3::UnitY()};
  for (std::size_t i = 0; i < collider.parts->size(); ++i) {
    const ShapePart& part = (*collider.parts)[i];
    const Pose& pose = collider.part_poses[i];
    const bool primitive = part.mesh == nullptr;
    const double reach = part.half.x() + part.half.y() + part.half.z() + margin;  // no less than the radius
    if (primitive && (local - pose.p).squaredNorm() > reach * reach) continue;
    const Distance d = (*collider.distances)[i]->at(pose.q.conjugate() * (local - pose.p));
    if (d.value < best.value) best = {d.value, collider.pose.q * (pose.q * d.normal)};
  }
  return best;
}

}  // namespace prosector
