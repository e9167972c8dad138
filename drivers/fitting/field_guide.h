#pragma once
// Guides a user placing a receiver on the points of a grid, to map a distorted magnetic field.

#include "drivers/fitting/field_fit.h"
#include "drivers/fitting/guide.h"
#include "drivers/fitting/position_recorder.h"

namespace prosector {

/// Grid of points at which a receiver is held to measure a distorted magnetic field: corners of its box in
/// the room, and number of points along each axis.
struct FieldGrid {
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();  // m, room
  std::array<std::size_t, 3> count = {5, 5, 5};
  std::optional<Quat> orientation;  // of the receiver at each point, room frame; none: unknown but constant
};

class FieldGuide final : public Guide {
 public:
  /// Starts a guided measurement of a distorted magnetic field, with the receiver of `role` held at each
  /// point of `grid`. `file` is the path of the map to be written, as the configuration shall contain it.
  /// Throws InputError for an invalid grid.
  FieldGuide(const ClientConfig& config, StationRole role, const FieldGrid& grid, std::string file);
  /// Returns the tracker settings to use while the distorted magnetic field is measured. Receiver poses are
  /// in the tracker's own frame, without corrections by a map.
  static DeviceConfig device(const ClientConfig& config);

  void take(const DeviceSample& sample) override;
  GuideStep step() const override;
  void back() override;
  GuideOutcome outcome() const override;
  /// Fits the map that corrects magnetic distortion to the receiver's poses recorded at the grid points. This
  /// takes seconds with a thousand points.
  FieldFit fit() const;
  /// Returns the result for the user of a fitted distortion map: text lines with its errors, and the change
  /// to the configuration that selects the map's file.
  GuideOutcome outcome_of(const FieldFit& fit) const;
  /// Returns the reported and the true pose of the receiver at each grid point recorded so far, in the
  /// tracker's frame.
  std::vector<FieldSample> samples() const;

 private:
  Pose room_device_;
  std::size_t station_;
  FieldGrid grid_;
  std::string file_;
  std::vector<Vec3> points_;  // room; consecutive points are neighbours
  /// A recorded pose of the receiver at a grid point, in the tracker's frame, and its expected error.
  struct Caught {
    Pose pose;
    PoseErrors error;  // expected error
  };
  std::vector<Caught> caught_;
  PositionRecorder catcher_;
  double reach_;  // m, greatest reported distance from a grid point that counts as on it
  std::string rejection_;
};

}  // namespace prosector
