#pragma once
// Converts a glove's raw counts to calibrated flexions and a gesture, for all 5DT gloves.

#include <array>
#include <cstdint>

#include "drivers/device/device.h"
#include "drivers/device/gesture.h"
#include "drivers/gloves/glove_config.h"

namespace prosector {

/// Scales each sensor to 0 open … 1 closed: with fixed counts, or with the range of all samples so far, (raw
/// − min)/(max − min). A range narrower than `least_span` counts gives 0.
class FlexionCalibrator {
 public:
  FlexionCalibrator(const GloveConfig& glove, double least_span);
  std::array<double, fingers> update(const std::array<double, fingers>& raw);

 private:
  bool falls_;
  std::optional<GloveCalibration> fixed_;
  double least_span_;
  std::array<double, fingers> min_, max_;
};

/// Converts raw counts (thumb first) to a hand's sample.
class GloveHand {
 public:
  GloveHand(const GestureThresholds& gestures, const GloveConfig& glove, double least_span);
  DeviceSample sample(const std::array<std::uint16_t, fingers>& raw, std::int64_t time_ns);
  /// Converts values that need not be counts, such as analog channels.
  DeviceSample sample(const std::array<double, fingers>& raw, std::int64_t time_ns);

 private:
  FlexionCalibrator calibrator_;
  GestureDetector gestures_;
  std::uint64_t records_ = 0;
};

}  // namespace prosector
