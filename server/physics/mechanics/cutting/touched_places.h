#pragma once
// Touched points of a body in its rest shape, used by local refinement.

#include <span>
#include <vector>

#include "common/math.h"

namespace prosector {

class TouchedPlaces {
 public:
  TouchedPlaces() = default;
  /// Takes points of the rest shape, m. Keeps one point, the first in lexicographic order, per cube of edge
  /// length `apart`, m.
  TouchedPlaces(std::vector<Vec3> points, double apart);

  bool empty() const { return places_.empty(); }
  std::span<const Vec3> all() const { return places_; }
  /// Returns the distance from the box to the nearest place, m; `limit` if no place is nearer.
  double distance(const Vec3& low, const Vec3& high, double limit) const;

  /// Returns whether a place is closer to the box than `limit`, m.
  bool within(const Vec3& low, const Vec3& high, double limit) const;

 private:
  bool all_beyond(const Vec3& low, const Vec3& high, double limit) const;

  std::vector<Vec3> places_;  // in order
  Vec3 low_ = Vec3::Zero(), high_ = Vec3::Zero();
};

}  // namespace prosector
