#pragma once
// How much later one device tells a motion than another: by cross-correlation of their series.
//
// Both series are laid on one grid of times by straight lines, freed of their means, and correlated at all
// lags up to the longest. Around the best lag b(t) = g·a(t − τ) + c is solved by least squares for τ, g and c
// (Gauss and Newton), which is finer than the grid. The error that is expected of τ follows from what is
// left, r:
//   σ_τ² = var(r) · m / (g² Σ ȧ²)
// m is the number of grid points over which r correlates with itself, for neighbours aren't independent.

#include <cstdint>
#include <span>

namespace prosector {

/// A number that two devices tell of one motion, at a time.
struct TimedValue {
  std::int64_t time_ns = 0;
  double value = 0;
};

struct DelayLimits {
  double longest = 0.5;      // s, either way
  double least_overlap = 2;  // s
  double least_correlation = 0.8;
};

struct DelayFit {
  double delay = 0;  // s: `late` is later than `early` by so much
  double error = 0;  // s RMS, expected
  double correlation = 0;
  double gain = 1;     // of `late` over `early`
  double seconds = 0;  // of both together
};

/// Fits. Throws InputError that says what to do where the series hardly overlap, hold no motion, don't fit
/// each other, or repeat themselves within the longest delay.
DelayFit fit_delay(std::span<const TimedValue> early, std::span<const TimedValue> late,
                   const DelayLimits& limits = {});

}  // namespace prosector
