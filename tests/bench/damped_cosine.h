#pragma once
// Frequency and decay of what swings.

#include <vector>

namespace prosector {

struct DampedCosine {
  double omega = 0;  // rad/s
  double decay = 0;  // 1/s: the amplitude goes with exp(−decay·t)
};

/// Least squares of e^(−decay·t)·(a cos ωt + b sin ωt) to the samples. Looks for ω between 0.2 and 3 times
/// `about`.
DampedCosine fit_damped_cosine(const std::vector<double>& times, const std::vector<double>& values,
                               double about);

}  // namespace prosector
