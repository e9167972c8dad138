#pragma once
// A glove's raw counts as calibrated flexions and a gesture: what both 5DT protocols share.

#include <array>
#include <cstdint>

#include "drivers/device.h"
#include "drivers/gesture.h"

namespace prosector {

/// Scales each sensor to 0 open … 1 closed: by fixed counts, or by the range seen so far, which every sample
/// widens: (raw − min)/(max − min). A range narrower than `least_span` counts is no bend yet and gives 0.
class FlexionCalibrator {
 public:
  FlexionCalibrator(const DeviceConfig& config, double least_span);
  std::array<double, fingers> update(const std::array<double, fingers>& raw);

 private:
  bool falls_;
  std::optional<GloveCalibration> fixed_;
  double least_span_;
  std::array<double, fingers> min_, max_;
};

/// Turns raw counts (thumb first) into the hand's part of a sample.
class GloveHand {
 public:
  GloveHand(const DeviceConfig& config, double least_span);
  DeviceSample sample(const std::array<std::uint16_t, fingers>& raw, std::int64_t time_ns);
  /// Takes values that need not be counts, as an analog's channels.
  DeviceSample sample(const std::array<double, fingers>& raw, std::int64_t time_ns);

 private:
  FlexionCalibrator calibrator_;
  GestureDetector gestures_;
  std::uint64_t records_ = 0;
};

}  // namespace prosector
