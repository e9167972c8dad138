#pragma once
// How noisy a resting receiver is, and how it drifts.
//
// To each axis of its positions a line p(t) = a + b t is fitted: b is the drift, and noise is the RMS of what
// is left. Orientations are taken as rotation vectors from their mean, in the frame that they are given in.

#include <cstdint>
#include <span>

#include "common/math.h"

namespace prosector {

struct TimedPose {
  std::int64_t time_ns = 0;
  Pose pose;
};

inline constexpr double least_rest_seconds = 1;
inline constexpr std::size_t least_rest_readings = 30;
inline constexpr double most_rest_motion = 0.02;  // m RMS; beyond it the receiver moved

struct RestFit {
  double noise = 0;                // m RMS, all three axes together
  double turn_noise = 0;           // rad RMS
  Vec3 axis_noise = Vec3::Zero();  // m RMS, each axis
  double drift = 0;                // m a minute
  double turn_drift = 0;           // rad a minute
  double drift_error = 0;          // m a minute, expected of `drift` by the noise alone
  double seconds = 0, rate = 0;    // s, Hz
  std::size_t readings = 0;
};

/// Measures. Throws InputError where there is too little, or the receiver moved.
RestFit fit_rest(std::span<const TimedPose> readings);

}  // namespace prosector
