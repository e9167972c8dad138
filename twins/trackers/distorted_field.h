#pragma once
// Simulated distortion of a tracker's field by a piece of metal.
//
// The metal at m acts as a dipole with the unit moment a: with r = x − m, d = |r|,
//   e(x) = (3 r (r·a)/d² − a) (d₀/d)³, d₀ = 0.5 m
// A receiver at x reports x + shift·e(x), rotated by turn·e(x) (a rotation vector). `shift` and `turn` are
// thus the errors at a distance of 0.5 m perpendicular to the moment.

#include "common/math.h"

namespace prosector {

struct DistortedField {
  Vec3 metal = Vec3::Zero();  // m, device frame
  Vec3 moment = Vec3(1, 0.3, 0.2).normalized();
  double shift = 0;  // m
  double turn = 0;   // rad

  /// Returns the pose that a receiver at the pose `truth` reports, with the error that the metal causes. Both
  /// are in the tracker's frame, m.
  Pose report(const Pose& truth) const;
};

}  // namespace prosector
