#pragma once
// Fit of a damped oscillation.

#include <vector>

namespace prosector {

struct DampedCosine {
  double omega = 0;  // rad/s
  double decay = 0;  // 1/s: the amplitude decays as exp(−decay·t)
};

/// Fits, by least squares, e^(−decay·t)·(a cos ωt + b sin ωt) to the samples. Searches ω between 0.2 and 3
/// times `about`.
DampedCosine fit_damped_cosine(const std::vector<double>& times, const std::vector<double>& values,
                               double about);

}  // namespace prosector
