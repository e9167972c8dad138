#pragma once
// Guides a person who swings an instrument about its resting tip, so that the tip is found.

#include "drivers/fitting/guide.h"
#include "drivers/fitting/pivot_fit.h"
#include "drivers/fitting/still_window.h"

namespace prosector {

class TipGuide final : public Guide {
 public:
  TipGuide(const ClientConfig& config, StationRole role);
  /// Returns how to open the tracker: the poses are the receivers'.
  static DeviceConfig device(const ClientConfig& config, StationRole role);

  void take(const DeviceSample& sample) override;
  GuideStep step() const override;
  void back() override;
  GuideOutcome outcome() const override;
  PivotFit fit() const { return fit_pivot(poses_); }

 private:
  StationRole role_;
  std::size_t station_;
  StillWindow window_;
  bool rests_ = false;  // the tip is in its place
  std::vector<Pose> poses_;
};

}  // namespace prosector
