#pragma once
// Converts a glove's raw counts to calibrated flexions and a gesture, for all 5DT gloves.

#include <array>
#include <cstdint>

#include "drivers/device/device.h"
#include "drivers/device/gesture.h"
#include "drivers/gloves/glove_config.h"

namespace prosector {

/// Calibrator that scales each sensor of a glove to a flexion, 0 open … 1 closed. It uses the calibrated
/// counts if there are any. Otherwise it uses the range of all samples so far, (raw − min)/(max − min), and
/// returns 0 while this range is narrower than `least_span` counts.
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

/// Converter of a glove's raw sensor counts (thumb first) to a device sample with calibrated flexions and a
/// gesture.
class GloveHand {
 public:
  GloveHand(const GestureThresholds& gestures, const GloveConfig& glove, double least_span);
  DeviceSample sample(const std::array<std::uint16_t, fingers>& raw, std::int64_t time_ns);
  /// Converts raw values, thumb first, that need not be integer counts, such as analog channels, to a device
  /// sample with flexions and a gesture.
  DeviceSample sample(const std::array<double, fingers>& raw, std::int64_t time_ns);

 private:
  FlexionCalibrator calibrator_;
  GestureDetector gestures_;
  std::uint64_t records_ = 0;
};

}  // namespace prosector
