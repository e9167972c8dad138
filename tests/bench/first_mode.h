#pragma once
// The first bending mode of the reference beam.

#include <array>
#include <cmath>

#include "server/calibration/beam_piece.h"

namespace prosector {

/// Direction in which the reference beam swings: along a diagonal of its section. A square section has the
/// same frequency in every direction. But a Kuhn mesh couples directions that are not along a diagonal of its
/// end face, and the plane of the swing would rotate. The mesh is softest in this direction.
inline const Vec3 swing_direction = Vec3(0, 1, -1).normalized();

/// Returns w and w′ of a clamped–free beam's first mode at x/L, 1 at the tip (Euler–Bernoulli; βL = 1.8751).
inline std::array<double, 2> first_mode(double share) {
  constexpr double b = 1.875104068711961, s = 0.734095513758;
  const double z = b * share;
  const double w = std::cosh(z) - std::cos(z) - s * (std::sinh(z) - std::sin(z));
  const double slope = b * (std::sinh(z) + std::sin(z) - s * (std::cosh(z) - std::cos(z)));
  return {w / 2, slope / 2};
}

/// Returns the beam's rest positions `rest` (3n, m) bent in `swing_direction` into the first mode of a
/// clamped–free beam (Euler–Bernoulli). The displacement at the tip is `amplitude` m.
inline VecX in_first_mode(const VecX& rest, double amplitude) {
  VecX x = rest;
  for (Eigen::Index k = 0; k < rest.size(); k += 3) {
    const auto [w, slope] = first_mode(rest[k] / beam_size[0]);
    const double across = swing_direction.dot(rest.segment<3>(k) - beam_tip());
    x.segment<3>(k) += amplitude * w * swing_direction;
    x[k] -= amplitude * slope / beam_size[0] * across;
  }
  return x;
}

}  // namespace prosector
