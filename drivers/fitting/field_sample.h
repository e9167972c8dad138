#pragma once
// Samples of a tracker's field map: reported and true poses.

#include <algorithm>
#include <span>

#include "common/math.h"

namespace prosector {

/// A pose reported by a tracker's receiver and its true pose at that moment, both in the tracker's frame, m.
struct FieldSample {
  Pose reported;
  Pose truth;
};

/// Returns the rotation that turns orientation `from` into orientation `to`, as the quaternion with
/// non-negative scalar part.
inline Quat turn_from(const Quat& from, const Quat& to) {
  Quat turn = to * from.conjugate();
  if (turn.w() < 0) turn.coeffs() = -turn.coeffs();
  return turn;
}

/// An axis-aligned box that contains sampled positions: its centre and half of its side lengths, m.
struct SampledBox {
  Vec3 centre, half;  // m
};
/// Returns the axis-aligned bounding box of the samples' positions. `of` returns the reported or the true
/// position of a sample, m.
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
