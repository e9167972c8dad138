#pragma once
// The beam of the reference values: 0.4 × 0.1 × 0.1 m, clamped at x = 0, E = 3e5 Pa, ρ = 1000 kg/m³.

#include "server/calibration/specimen.h"

namespace prosector {

inline const Vec3 beam_size(0.4, 0.1, 0.1);
/// First bending frequency (Hz) of the reference beam, a clamped continuum of 0.4 × 0.1 × 0.1 m with Poisson
/// ratio 0.3. Converged to a relative error of 2e-4.
inline constexpr double beam_first_frequency = 1.6864;

/// Makes the reference beam with `cells` cells along its length. The number is a multiple of 4, or of 8 for a
/// node at the tip's centre.
TestPiece beam_piece(unsigned cells, double poisson_ratio);

/// Returns the centre of the reference beam's free end face, m.
inline Vec3 beam_tip() {
  return {beam_size[0], beam_size[1] / 2, beam_size[2] / 2};
}

}  // namespace prosector
