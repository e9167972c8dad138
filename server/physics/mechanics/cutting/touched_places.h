#pragma once
// Touched points of a body in its rest shape, used by local refinement.

#include <span>
#include <vector>

#include "common/math.h"

namespace prosector::cutting {

class TouchedPlaces {
 public:
  TouchedPlaces() = default;
  /// Stores the points of a body, in its rest shape (m), at which hands or other bodies touch it. Of the
  /// points in each cube of a grid with spacing `apart`, m, only the first in lexicographic order is kept.
  TouchedPlaces(std::vector<Vec3> points, double apart);

  bool empty() const { return places_.empty(); }
  std::span<const Vec3> all() const { return places_; }
  /// Returns the distance, m, from the box low–high to the nearest touched point; `limit` if none is closer
  /// than `limit`.
  double distance(const Vec3& low, const Vec3& high, double limit) const;

  /// Returns whether a touched point is closer to the box low–high than `limit`, m.
  bool within(const Vec3& low, const Vec3& high, double limit) const;

 private:
  bool all_beyond(const Vec3& low, const Vec3& high, double limit) const;

  std::vector<Vec3> places_;  // in order
  Vec3 low_ = Vec3::Zero(), high_ = Vec3::Zero();
};

}  // namespace prosector::cutting
