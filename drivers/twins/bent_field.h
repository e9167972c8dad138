#pragma once
// A tracker's field bent by a piece of metal, as a twin's reports show it.
//
// The metal at m acts as a dipole with the unit moment a: with r = x − m, d = |r|,
//   e(x) = (3 r (r·a)/d² − a) (d₀/d)³, d₀ = 0.5 m
// A receiver at x reports x + shift·e(x), turned by turn·e(x) (a rotation vector). So shift and turn are what
// the metal does half a metre beside it.

#include "common/math.h"

namespace prosector {

struct BentField {
  Vec3 metal = Vec3::Zero();  // m, device frame
  Vec3 moment = Vec3(1, 0.3, 0.2).normalized();
  double shift = 0;  // m
  double turn = 0;   // rad

  /// Returns what is reported where the pose is `truth`, device frame.
  Pose report(const Pose& truth) const;
};

}  // namespace prosector
