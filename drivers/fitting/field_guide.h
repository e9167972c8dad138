#pragma once
// Guides a user placing a receiver on the points of a grid, to map a distorted magnetic field.

#include "drivers/fitting/field_fit.h"
#include "drivers/fitting/guide.h"
#include "drivers/fitting/position_recorder.h"

namespace prosector {

/// The grid's box in the room, and the number of points along each axis.
struct FieldGrid {
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();  // m, room
  std::array<std::size_t, 3> count = {5, 5, 5};
  std::optional<Quat> orientation;  // of the receiver at each point, room frame; none: unknown but constant
};

class FieldGuide final : public Guide {
 public:
  /// Starts with the grid. `file`: path of the map to be written, as in the configuration. Throws InputError
  /// for an invalid grid.
  FieldGuide(const ClientConfig& config, StationRole role, const FieldGrid& grid, std::string file);
  /// Returns the configuration to open the tracker with: receiver poses in the tracker's frame, without a
  /// map.
  static DeviceConfig device(const ClientConfig& config);

  void take(const DeviceSample& sample) override;
  GuideStep step() const override;
  void back() override;
  GuideOutcome outcome() const override;
  /// Fits the map; takes seconds with a thousand points.
  FieldFit fit() const;
  /// Returns the outcome of a fit.
  GuideOutcome outcome_of(const FieldFit& fit) const;
  /// Returns the reported and true poses in the device's frame, for display.
  std::vector<FieldSample> samples() const;

 private:
  Pose room_device_;
  std::size_t station_;
  FieldGrid grid_;
  std::string file_;
  std::vector<Vec3> points_;  // room; consecutive points are neighbours
  /// A recorded position, in the device's frame.
  struct Caught {
    Pose pose;
    PoseErrors error;  // expected error
  };
  std::vector<Caught> caught_;
  PositionRecorder catcher_;
  double reach_;  // m, greatest reported distance from a grid point that counts as on it
  std::string trouble_;
};

}  // namespace prosector
