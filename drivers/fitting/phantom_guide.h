#pragma once
// Guides a person who touches known points of a phantom, so that its shape's place is found: on the board
// that is fixed to it, or in the room.

#include "drivers/fitting/room_guide.h"

namespace prosector {

class PhantomGuide final : public RoomGuide {
 public:
  /// Touches `points` in their order. `targets`: where the error is told; none: amid the points. All are in
  /// the shape's frame, m. Throws InputError as RoomGuide does, and where the phantom has no shape.
  PhantomGuide(const ClientConfig& config, StationRole role, std::vector<Vec3> points,
               std::vector<Vec3> targets);
  /// Returns how to open the tracker, at its boards' address: its poses are in the frame of the phantom's
  /// board, or in the room.
  /// Throws InputError where the phantom has a board and the tracker sees none.
  static DeviceConfig device(const ClientConfig& config);

  GuideOutcome outcome() const override;

 private:
  std::vector<Vec3> targets_;
};

}  // namespace prosector
