#pragma once
// A glove that is tried on: the hand that it makes, how far each sensor goes, and gestures as they are known.

#include <array>
#include <map>
#include <memory>

#include "client/setup/device_watch.h"
#include "client/setup/live_panel.h"

namespace prosector {

/// How far a glove's sensors went, by what was seen of them.
class SeenSpans {
 public:
  void take(const std::array<std::uint16_t, fingers>& counts);
  /// Returns counts between the least and the most that were seen.
  double span(std::size_t finger) const;
  /// Returns which share of its calibrated span a finger went through; 1 without a calibration.
  double share(std::size_t finger, const std::optional<GloveCalibration>& calibration) const;

 private:
  std::array<std::uint16_t, fingers> least_{}, most_{};
  bool any_ = false;
};

class GloveLive final : public LivePanel {
 public:
  const char* name() const override { return msg("Try it on"); }
  const char* about() const override {
    return msg("Open and close the whole hand, bend each finger, and make each gesture.");
  }
  void draw(Interface& ui, ConfigDraft& draft, Said& said, std::int64_t now_ns) override;
  void close() override;
  bool open() const override { return watch_ != nullptr; }

 private:
  std::size_t hand_ = right_hand;
  std::unique_ptr<DeviceWatch> watch_;  // of the glove on that hand
  SeenSpans spans_;
  std::map<Gesture, bool> made_;

  void begin(const ClientConfig& config);
  void draw_hand(Interface& ui, const DeviceSample& sample) const;
  void draw_bars(Interface& ui, const DeviceSample& sample, const GloveSettings& glove) const;
  void draw_gestures(Interface& ui, const DeviceSample& sample, const ClientConfig& config) const;
};

}  // namespace prosector
