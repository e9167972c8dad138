#pragma once
// Live test of a glove: the hand, each sensor's range, and the recognised gestures.

#include <array>
#include <map>
#include <memory>

#include "client/setup/device_watch.h"
#include "client/setup/live_panel.h"

namespace prosector {

/// Smallest and largest count observed for each sensor of a glove.
class ObservedRanges {
 public:
  void take(const std::array<std::uint16_t, fingers>& counts);
  /// Returns the difference between the largest and the smallest count observed for the finger's sensor.
  double span(std::size_t finger) const;
  /// Returns the fraction, 0 … 1, of the finger's calibrated range that the observed counts cover; 1 without
  /// a calibration.
  double share(std::size_t finger, const std::optional<GloveCalibration>& calibration) const;

 private:
  std::array<std::uint16_t, fingers> least_{}, most_{};
  bool any_ = false;
};

class GloveTestPanel final : public LivePanel {
 public:
  const char* name() const override { return msg("Test"); }
  const char* about() const override {
    return msg("Open and close the whole hand, bend each finger, and make each gesture.");
  }
  void draw(Interface& ui, ConfigDraft& draft, Said& said, std::int64_t now_ns) override;
  void close() override;
  bool open() const override { return watch_ != nullptr; }

 private:
  std::size_t hand_ = right_hand;
  std::unique_ptr<DeviceWatch> watch_;  // of the glove on that hand
  ObservedRanges spans_;
  std::map<Gesture, bool> made_;

  void begin(const ClientConfig& config);
  void draw_hand(Interface& ui, const DeviceSample& sample) const;
  void draw_bars(Interface& ui, const DeviceSample& sample, const GloveSettings& glove) const;
  void draw_gestures(Interface& ui, const DeviceSample& sample, const ClientConfig& config) const;
};

}  // namespace prosector
