#pragma once
// The beam of the reference values: 0.4 × 0.1 × 0.1 m, clamped at x = 0, E = 3e5 Pa, ρ = 1000 kg/m³.

#include "server/calibration/specimen.h"

namespace prosector {

inline const Vec3 beam_size(0.4, 0.1, 0.1);
/// Hz: first bending mode of the continuum at ν = 0.3, converged to 2e-4.
inline constexpr double beam_first_frequency = 1.6864;

/// Makes a beam of `cells` along it, a multiple of 4 or, so that a node is at the tip's centre, of 8.
TestPiece beam_piece(unsigned cells, double poisson_ratio);

/// Direction of the swing: across the diagonal. A square section has the same frequency in every direction.
/// But a Kuhn mesh couples directions that are not along a diagonal of its end face, and the swing would
/// turn. Along this one it is softest.
inline const Vec3 swing_direction = Vec3(0, 1, -1).normalized();

/// Bends the rest positions in that direction as a clamped–free beam's first mode (Euler and Bernoulli),
/// `amplitude` m at the tip.
VecX in_first_mode(const VecX& rest, double amplitude);

/// Returns the free face's centre.
inline Vec3 beam_tip() {
  return {beam_size[0], beam_size[1] / 2, beam_size[2] / 2};
}

}  // namespace prosector
