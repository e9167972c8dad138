#pragma once
// Delay of one device's measurement of a motion relative to another's, by cross-correlation.
//
// Both series are linearly interpolated to a common time grid, their means are subtracted, and they are
// correlated at all lags up to the longest. Around the best lag, b(t) = g·a(t − τ) + c is solved by least
// squares for τ, g and c (Gauss and Newton). This resolves τ finer than the grid. The expected error of τ
// follows from the residual r:
//   σ_τ² = var(r) · m / (g² Σ ȧ²)
// m is the correlation length of r in grid points, because neighbours aren't independent.

#include <cstdint>
#include <span>

namespace prosector {

/// A sample of a motion measured by a device: the value, in any unit, and the time of measurement.
struct TimedValue {
  std::int64_t time_ns = 0;
  double value = 0;
};

struct DelayLimits {
  double longest = 0.5;      // s, largest absolute delay
  double least_overlap = 2;  // s
  double least_correlation = 0.8;
};

struct DelayFit {
  double delay = 0;  // s: delay of `late` relative to `early`
  double error = 0;  // s, expected RMS error
  double correlation = 0;
  double gain = 1;     // amplitude of `late` divided by that of `early`
  double seconds = 0;  // s, overlap of both series
};

/// Fits the delay of the motion `late` measured by one device relative to the same motion `early` measured by
/// another. Throws InputError with advice if the series hardly overlap, do not correlate (no motion, or
/// another motion), or repeat themselves within the longest delay.
DelayFit fit_delay(std::span<const TimedValue> early, std::span<const TimedValue> late,
                   const DelayLimits& limits = {});

}  // namespace prosector
