#pragma once
// Guides a person who puts a receiver onto the points of a grid, so that a bent field is mapped.

#include "drivers/fitting/field_fit.h"
#include "drivers/fitting/guide.h"
#include "drivers/fitting/place_catcher.h"

namespace prosector {

/// The grid's box in the room, and how many points it has along each axis.
struct FieldGrid {
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();  // m, room
  std::array<std::size_t, 3> count = {5, 5, 5};
  std::optional<Quat> orientation;  // of the receiver at each point, room; none: the same at all, but unknown
};

class FieldGuide final : public Guide {
 public:
  /// Takes the grid, and as `file` where the map will be, as the configuration names it. Throws InputError
  /// for a grid that is none.
  FieldGuide(const ClientConfig& config, StationRole role, const FieldGrid& grid, std::string file);
  /// Returns how to open the tracker: poses are the receivers' in its own frame, without a map.
  static DeviceConfig device(const ClientConfig& config);

  void take(const DeviceSample& sample) override;
  GuideStep step() const override;
  void back() override;
  GuideOutcome outcome() const override;
  /// Fits, which takes seconds with a thousand points.
  FieldFit fit() const;
  /// Returns what came out, of a fit that is there already.
  GuideOutcome outcome_of(const FieldFit& fit) const;
  /// Returns what was reported where, in the device's frame: what a picture shows.
  std::vector<FieldSample> samples() const;

 private:
  Pose room_device_;
  std::size_t station_;
  FieldGrid grid_;
  std::string file_;
  std::vector<Vec3> points_;  // room; neighbours follow each other
  /// A place that was caught, in the device's frame.
  struct Caught {
    Pose pose;
    PoseErrors error;  // expected
  };
  std::vector<Caught> caught_;
  PlaceCatcher catcher_;
  double reach_;  // m: from a point, as reported, that still counts as there
  std::string trouble_;
};

}  // namespace prosector
