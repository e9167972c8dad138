#include "server/physics/mechanics/collision/narrow/gjk.h"

#include <cmath>
#include <limits>

namespace prosector::collision {
namespace {

constexpr std::array<std::array<std::size_t, 4>, 4> faces{
    {{0, 1, 2, 3}, {0, 1, 3, 2}, {0, 2, 3, 1}, {1, 2, 3, 0}}};

}  // namespace

Vec3 Gjk::nearest() const {
  Vec3 out = Vec3::Zero();
  for (std::size_t i = 0; i < count_; ++i) out += weights_[i] * corners_[i].difference;
  return out;
}

bool Gjk::origin_inside() const {
  for (const auto& [i, j, k, opposite] : faces) {
    const Vec3& p = corners_[i].difference;
    const Vec3 normal = (corners_[j].difference - p).cross(corners_[k].difference - p);
    const double height = normal.dot(corners_[opposite].difference - p), origin = -normal.dot(p);
    const double size = (corners_[opposite].difference - p).norm() * normal.norm();
    if (!(std::abs(height) > 1e-14 * size) || height * origin < 0) return false;
  }
  return true;
}

void Gjk::keep(const std::array<std::size_t, 3>& which, const Vec3& weights) {
  const std::array<Corner, 4> old = corners_;
  count_ = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double weight = weights[static_cast<Eigen::Index>(i)];
    if (!(weight > 0)) continue;
    corners_[count_] = old[which[i]];
    weights_[count_++] = weight;
  }
}

bool Gjk::reduce() {
  const auto weights_of = [&](std::size_t i, std::size_t j, std::size_t k) {
    return closest_weights(Vec3::Zero(), corners_[i].difference, corners_[j].difference,
                           corners_[k].difference);
  };
  if (count_ == 2) {
    const Vec3 &p = corners_[0].difference, way = corners_[1].difference - p;
    const double length = way.squaredNorm();
    const double along = length > 0 ? std::clamp(-p.dot(way) / length, 0.0, 1.0) : 0;
    keep({0, 1, 1}, {1 - along, along, 0});
    return true;
  }
  if (count_ == 3) {
    keep({0, 1, 2}, weights_of(0, 1, 2));
    return true;
  }
  if (origin_inside()) return false;
  double least = std::numeric_limits<double>::infinity();
  std::array<std::size_t, 3> which{};
  Vec3 weights = Vec3::Zero();
  for (const auto& [i, j, k, opposite] : faces) {
    const Vec3 w = weights_of(i, j, k);
    const double d =
        (w[0] * corners_[i].difference + w[1] * corners_[j].difference + w[2] * corners_[k].difference)
            .squaredNorm();
    if (!(d < least)) continue;
    least = d;
    which = {i, j, k};
    weights = w;
  }
  keep(which, weights);
  return true;
}

}  // namespace prosector::collision
