#pragma once
// Samples of a tracker's field map: reported and true poses.

#include <algorithm>
#include <span>

#include "common/math.h"

namespace prosector {

/// A pose reported by the receiver and its true pose, in the device's frame.
struct FieldSample {
  Pose reported;
  Pose truth;
};

/// Returns the rotation from one orientation to another, by the smaller angle.
inline Quat turn_from(const Quat& from, const Quat& to) {
  Quat turn = to * from.conjugate();
  if (turn.w() < 0) turn.coeffs() = -turn.coeffs();
  return turn;
}

/// An axis-aligned box.
struct SampledBox {
  Vec3 centre, half;  // m
};
/// Returns the bounding box of the samples' positions; `of` returns a sample's position.
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
