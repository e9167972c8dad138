#pragma once
// Guides a user swinging an instrument about its resting tip, to find the tip's position.

#include "drivers/fitting/guide.h"
#include "drivers/fitting/pivot_fit.h"
#include "drivers/fitting/stillness_detector.h"

namespace prosector {

class TipGuide final : public Guide {
 public:
  TipGuide(const ClientConfig& config, StationRole role);
  /// Returns the tracker settings to use during the calibration of an instrument's tip. Poses are those of
  /// the receivers in the tracker's own frame, because the tip's position is still unknown.
  static DeviceConfig device(const ClientConfig& config, StationRole role);

  void take(const DeviceSample& sample) override;
  GuideStep step() const override;
  void back() override;
  GuideOutcome outcome() const override;
  PivotFit fit() const { return fit_pivot(poses_); }

 private:
  StationRole role_;
  std::size_t station_;
  StillnessDetector window_;
  bool rests_ = false;  // the tip is in place
  std::vector<Pose> poses_;
};

}  // namespace prosector
