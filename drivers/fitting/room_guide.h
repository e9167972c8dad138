#pragma once
// Guides a user touching known points in the room. The result is the tracker's pose.

#include "drivers/fitting/guide.h"
#include "drivers/fitting/position_recorder.h"
#include "drivers/fitting/rigid_fit.h"

namespace prosector {

class RoomGuide : public Guide {
 public:
  /// Starts the guide; the user touches `points` (m, room) in order with the receiver of `role`. Throws
  /// InputError if the points don't determine a pose.
  RoomGuide(const ClientConfig& config, StationRole role, std::vector<Vec3> points);
  /// Returns the configuration to open the tracker with: poses in the tracker's own frame.
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
  std::string trouble_;
  int refused_ = 0;  // rejected attempts in a row
};

}  // namespace prosector
