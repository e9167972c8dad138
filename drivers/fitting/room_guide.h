#pragma once
// Guides a person who touches known points of the room, so that the tracker's place is found.

#include "drivers/fitting/guide.h"
#include "drivers/fitting/place_catcher.h"
#include "drivers/fitting/rigid_fit.h"

namespace prosector {

class RoomGuide : public Guide {
 public:
  /// Touches `points` (m, room) in their order with what the receiver of a role tracks. Throws InputError
  /// where they can't give a pose.
  RoomGuide(const ClientConfig& config, StationRole role, std::vector<Vec3> points);
  /// Returns how to open the tracker: its poses are in its own frame.
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
  PlaceCatcher catcher_;
  std::string trouble_;
  int refused_ = 0;  // tries in a row
};

}  // namespace prosector
