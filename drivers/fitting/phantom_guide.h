#pragma once
// Guides a user touching known points of a phantom. The result is the pose of the phantom's shape on its
// board, or in the room.

#include "drivers/fitting/room_guide.h"

namespace prosector {

class PhantomGuide final : public RoomGuide {
 public:
  /// Starts the guide; the user touches `points` in order. `targets`: points at which to report the error; if
  /// empty, it is the points' centre. All are in the shape's frame, m. Throws InputError like RoomGuide, or
  /// if the phantom has no shape.
  PhantomGuide(const ClientConfig& config, StationRole role, std::vector<Vec3> points,
               std::vector<Vec3> targets);
  /// Returns the configuration to open the tracker with, at the boards' address. Its poses are in the frame
  /// of the phantom's board, or in the room. Throws InputError if the phantom has a board and the tracker
  /// detects none.
  static DeviceConfig device(const ClientConfig& config);

  GuideOutcome outcome() const override;

 private:
  std::vector<Vec3> targets_;
};

}  // namespace prosector
