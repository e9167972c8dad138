#include "server/calibration/beam_piece.h"

#include <array>
#include <cmath>

#include "common/anatomy/kuhn_box.h"

namespace prosector {
namespace {

/// Returns w and w′ of a clamped–free beam's first mode at x/L, 1 at the tip (Euler–Bernoulli; βL = 1.8751).
std::array<double, 2> first_mode(double share) {
  constexpr double b = 1.875104068711961, s = 0.734095513758;
  const double z = b * share;
  const double w = std::cosh(z) - std::cos(z) - s * (std::sinh(z) - std::sin(z));
  const double slope = b * (std::sinh(z) + std::sin(z) - s * (std::cosh(z) - std::cos(z)));
  return {w / 2, slope / 2};
}

}  // namespace

TestPiece beam_piece(unsigned cells, double poisson_ratio) {
  TestPiece piece;
  piece.mesh = kuhn_box(beam_size, cells, cells / 4, cells / 4);
  piece.poisson_ratio = poisson_ratio;
  piece.clamped_axis = 0;
  return piece;
}

VecX in_first_mode(const VecX& rest, double amplitude) {
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
