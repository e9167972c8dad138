#include "drivers/gloves/glove_hand.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace prosector {

FlexionCalibrator::FlexionCalibrator(const GloveConfig& glove, double least_span)
    : falls_(glove.falls_on_bending), fixed_(glove.calibration), least_span_(least_span) {
  min_.fill(std::numeric_limits<double>::infinity());
  max_.fill(-std::numeric_limits<double>::infinity());
}

std::array<double, fingers> FlexionCalibrator::update(const std::array<double, fingers>& raw) {
  std::array<double, fingers> flexion{};
  for (std::size_t i = 0; i < fingers; ++i) {
    const double count = raw[i];
    min_[i] = std::min(min_[i], count);
    max_[i] = std::max(max_[i], count);
    const double open = fixed_ ? fixed_->open[i] : falls_ ? max_[i] : min_[i];
    const double closed = fixed_ ? fixed_->closed[i] : falls_ ? min_[i] : max_[i];
    const double span = closed - open;
    const bool bends = fixed_ ? span != 0 : std::abs(span) >= least_span_;
    flexion[i] = bends ? std::clamp((count - open) / span, 0.0, 1.0) : 0.0;
  }
  return flexion;
}

GloveHand::GloveHand(const GestureThresholds& gestures, const GloveConfig& glove, double least_span)
    : calibrator_(glove, least_span), gestures_(gestures) {}

DeviceSample GloveHand::sample(const std::array<std::uint16_t, fingers>& raw, std::int64_t time_ns) {
  std::array<double, fingers> counts{};
  std::ranges::copy(raw, counts.begin());
  DeviceSample out = sample(counts, time_ns);
  out.raw_flexion = raw;
  return out;
}

DeviceSample GloveHand::sample(const std::array<double, fingers>& raw, std::int64_t time_ns) {
  DeviceSample out;
  out.record = records_++;
  out.time_ns = time_ns;
  out.has_flexion = true;
  out.flexion = calibrator_.update(raw);
  out.gesture = gestures_.update(out.flexion);
  return out;
}

}  // namespace prosector
