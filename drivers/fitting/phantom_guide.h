#pragma once
// Guides a user touching known points of a phantom. The result is the pose of the phantom's shape on its
// board, or in the room.

#include "drivers/fitting/room_guide.h"

namespace prosector {

class PhantomGuide final : public RoomGuide {
 public:
  /// Starts a guided calibration of a phantom's pose, in which the user touches `points` in order with the
  /// receiver of `role`. `targets` are points at which the expected error is reported; if empty, it is
  /// reported at the points' centre. All are in the frame of the phantom's shape, m. Throws InputError if the
  /// points do not determine a pose or the phantom has no shape.
  PhantomGuide(const ClientConfig& config, StationRole role, std::vector<Vec3> points,
               std::vector<Vec3> targets);
  /// Returns the tracker settings to use during the calibration of the phantom's pose. Poses are in the frame
  /// of the phantom's board, or in the room frame if it has none. Throws InputError if the phantom has a
  /// board and the tracker cannot detect boards.
  static DeviceConfig device(const ClientConfig& config);

  GuideOutcome outcome() const override;

 private:
  std::vector<Vec3> targets_;
};

}  // namespace prosector
