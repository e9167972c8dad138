#pragma once
// Noise and drift of a resting receiver.
//
// A line p(t) = a + b t is fitted to each axis of the positions: b is the drift, and the RMS residual is the
// noise. Orientations are treated as rotation vectors relative to the first one, in the frame of the poses.

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
inline constexpr double max_rest_motion = 0.02;  // m RMS; above it the receiver moved

struct RestFit {
  double noise = 0;                // m RMS, all three axes together
  double turn_noise = 0;           // rad RMS
  Vec3 axis_noise = Vec3::Zero();  // m RMS, each axis
  double drift = 0;                // m per minute
  double turn_drift = 0;           // rad per minute
  double drift_error = 0;          // m per minute, expected error of `drift` due to noise
  double seconds = 0, rate = 0;    // s; Hz
  std::size_t readings = 0;
};

/// Measures noise and drift of a receiver from its readings at rest. Throws InputError if there are too few
/// readings or the receiver moved.
RestFit fit_rest(std::span<const TimedPose> readings);

}  // namespace prosector
