#pragma once
// Guides a user touching known points in the room. The result is the tracker's pose.

#include "drivers/fitting/guide.h"
#include "drivers/fitting/position_recorder.h"
#include "drivers/fitting/rigid_fit.h"

namespace prosector {

class RoomGuide : public Guide {
 public:
  /// Starts a guided calibration of a tracker's pose in the room. The user touches `points` (m, room frame)
  /// in order with the receiver of `role`. Throws InputError if the points do not determine a pose, or
  /// consecutive ones are too close.
  RoomGuide(const ClientConfig& config, StationRole role, std::vector<Vec3> points);
  /// Returns the tracker settings to use during the calibration of the tracker's pose in the room. Poses are
  /// in the tracker's own frame, because its pose in the room is still unknown.
  static DeviceConfig device(const ClientConfig& config);

  void take(const DeviceSample& sample) override;
  GuideStep step() const override;
  void back() override;
  GuideOutcome outcome() const override;
  RigidFit fit() const { return fit_rigid(touched_); }

 private:
  bool plausible(const Vec3& place);

  std::size_t station_;
  std::vector<Vec3> points_;
  std::vector<TouchedPoint> touched_;
  PositionRecorder catcher_;
  std::string rejection_;
  int refused_ = 0;  // rejected attempts in a row
};

}  // namespace prosector
