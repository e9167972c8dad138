#include "server/physics/mechanics/cutting/touched_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "common/assert.h"

namespace prosector::cutting {
namespace {

/// Returns the distance between a point and a box, m.
double to_box(const Vec3& point, const Vec3& low, const Vec3& high) {
  return (point - point.cwiseMax(low).cwiseMin(high)).norm();
}

std::array<double, 3> cube_of(const Vec3& point, double apart) {
  return {std::floor(point.x() / apart), std::floor(point.y() / apart), std::floor(point.z() / apart)};
}

bool is_before(const Vec3& a, const Vec3& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

}  // namespace

TouchedPlaces::TouchedPlaces(std::vector<Vec3> points, double apart) : places_(std::move(points)) {
  PROSECTOR_ASSERT(apart > 0);
  std::sort(places_.begin(), places_.end(), [&](const Vec3& a, const Vec3& b) {
    const auto of_a = cube_of(a, apart), of_b = cube_of(b, apart);
    return of_a != of_b ? of_a < of_b : is_before(a, b);
  });
  const auto in_one = [&](const Vec3& a, const Vec3& b) { return cube_of(a, apart) == cube_of(b, apart); };
  places_.erase(std::unique(places_.begin(), places_.end(), in_one), places_.end());
  if (places_.empty()) return;
  low_ = high_ = places_.front();
  for (const Vec3& place : places_) {
    low_ = low_.cwiseMin(place);
    high_ = high_.cwiseMax(place);
  }
}

/// Returns whether the box is at least `limit` away from the bounding box of all places.
bool TouchedPlaces::all_beyond(const Vec3& low, const Vec3& high, double limit) const {
  const Vec3 between = (low - high_).cwiseMax(low_ - high).cwiseMax(Vec3::Zero());
  return places_.empty() || between.norm() >= limit;
}

bool TouchedPlaces::within(const Vec3& low, const Vec3& high, double limit) const {
  return !all_beyond(low, high, limit) && std::any_of(places_.begin(), places_.end(), [&](const Vec3& place) {
    return to_box(place, low, high) < limit;
  });
}

double TouchedPlaces::distance(const Vec3& low, const Vec3& high, double limit) const {
  if (all_beyond(low, high, limit)) return limit;
  double nearest = limit;
  for (const Vec3& place : places_) nearest = std::min(nearest, to_box(place, low, high));
  return nearest;
}

}  // namespace prosector::cutting
