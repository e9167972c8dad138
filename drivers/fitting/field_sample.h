#pragma once
// What a receiver reported at a place that is known.

#include <algorithm>
#include <span>

#include "common/math.h"

namespace prosector {

/// What the receiver reported at a place, and what its pose is known to be; device frame.
struct FieldSample {
  Pose reported;
  Pose truth;
};

/// Returns the turn from one orientation to another, the shorter way round.
inline Quat turn_from(const Quat& from, const Quat& to) {
  Quat turn = to * from.conjugate();
  if (turn.w() < 0) turn.coeffs() = -turn.coeffs();
  return turn;
}

/// A box along the axes.
struct SampledBox {
  Vec3 centre, half;  // m
};
/// Returns the box that places fill: `of` gives a sample's.
template <class Place>
SampledBox box_of(std::span<const FieldSample> samples, const Place& of) {
  Vec3 low = of(samples.front()), high = low;
  for (const FieldSample& s : samples) {
    low = low.cwiseMin(of(s));
    high = high.cwiseMax(of(s));
  }
  return {(low + high) / 2, (high - low) / 2};
}

}  // namespace prosector
