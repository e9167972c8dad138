#pragma once
// Guides that record for some seconds: a receiver at rest, and a hand whose motion two devices measure.

#include "drivers/fitting/delay_fit.h"
#include "drivers/fitting/guide.h"
#include "drivers/fitting/rest_fit.h"

namespace prosector {

class RestGuide final : public Guide {
 public:
  RestGuide(std::size_t station, double seconds) : station_(station), seconds_(seconds) {}
  void take(const DeviceSample& sample) override;
  GuideStep step() const override;
  void back() override { readings_.clear(); }
  GuideOutcome outcome() const override;
  RestFit fit() const { return fit_rest(readings_); }

 private:
  double passed() const;

  std::size_t station_;
  double seconds_;
  std::vector<TimedPose> readings_;
};

/// Guided measurement of the delay between two devices that measure the same motion for some seconds. Each
/// device may use its own frame and unit, because the distances from the mean position are compared.
class DelayGuide final : public Guide {
 public:
  DelayGuide(std::size_t station, double seconds) : station_(station), seconds_(seconds) {}
  void take(const DeviceSample& sample) override;
  /// Adds a position that the second of the two compared devices measured at `time_ns`, in any frame and
  /// unit.
  void add_other_position(std::int64_t time_ns, const Vec3& place) {
    other_.push_back({time_ns, {place, Quat::Identity()}});
  }
  GuideStep step() const override;
  void back() override;
  GuideOutcome outcome() const override;
  DelayFit fit() const;

 private:
  std::size_t station_;
  double seconds_;
  std::vector<TimedPose> own_, other_;
};

}  // namespace prosector
