#include "tests/bench/damped_cosine.h"

#include <cmath>

#include <Eigen/Dense>

namespace prosector {
namespace {

/// Returns the residual with the best a and b for ω and decay: variable projection (Golub and Pereyra 1973).
double misfit(const std::vector<double>& times, const std::vector<double>& values,
              const DampedCosine& trial) {
  Eigen::Matrix2d A = Eigen::Matrix2d::Zero();
  Eigen::Vector2d b = Eigen::Vector2d::Zero();
  double square = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double envelope = std::exp(-trial.decay * times[i]);
    const Eigen::Vector2d basis(envelope * std::cos(trial.omega * times[i]),
                                envelope * std::sin(trial.omega * times[i]));
    A += basis * basis.transpose();
    b += basis * values[i];
    square += values[i] * values[i];
  }
  const double left = square - b.dot(A.ldlt().solve(b));
  return std::isfinite(left) ? left : square;
}

}  // namespace

DampedCosine fit_damped_cosine(const std::vector<double>& times, const std::vector<double>& values,
                               double about) {
  DampedCosine best{about, 0};
  double least = misfit(times, values, best);
  const auto keep_better = [&](const DampedCosine& trial) {
    const double left = misfit(times, values, trial);
    const bool better = left < least;
    if (better) least = left, best = trial;
    return better;
  };
  for (int i = 0; i <= 140; ++i) {
    for (int k = 0; k <= 8; ++k) keep_better({about * (0.2 + 0.02 * i), about * 0.05 * k});
  }
  // Compass search around the best grid point.
  for (double step = 0.01 * about; step > 1e-9 * about;) {
    const DampedCosine at = best;
    const bool better = keep_better({at.omega + step, at.decay}) ||
                        keep_better({at.omega - step, at.decay}) ||
                        keep_better({at.omega, at.decay + step}) || keep_better({at.omega, at.decay - step});
    if (!better) step /= 2;
  }
  return best;
}

}  // namespace prosector
