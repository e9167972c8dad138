#pragma once
// Where something touches a body, as points of its rest shape: what local refinement follows.

#include <span>
#include <vector>

#include "common/math.h"

namespace prosector {

class TouchedPlaces {
 public:
  TouchedPlaces() = default;
  /// Takes points of the rest shape, m. Of those in one cube of `apart` m the first in order of the points
  /// stands for all.
  TouchedPlaces(std::vector<Vec3> points, double apart);

  bool empty() const { return places_.empty(); }
  std::span<const Vec3> all() const { return places_; }
  /// Returns the distance from the box to the nearest place, m; `limit`, where none is nearer.
  double distance(const Vec3& low, const Vec3& high, double limit) const;

  /// Tells whether a place is nearer to the box than `limit`, m.
  bool within(const Vec3& low, const Vec3& high, double limit) const;

 private:
  bool all_beyond(const Vec3& low, const Vec3& high, double limit) const;

  std::vector<Vec3> places_;  // in order
  Vec3 low_ = Vec3::Zero(), high_ = Vec3::Zero();
};

}  // namespace prosector
