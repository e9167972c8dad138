#pragma once
// Interface of interactive calibrations: takes samples, returns the next instruction and finally the outcome.
// It is independent of the user interface; a window and a terminal both show guides.

#include <optional>
#include <string>
#include <vector>

#include "drivers/config/client_config_write.h"
#include "drivers/device/device.h"

namespace prosector {

/// Current step of a guided calibration: the instruction for the user, the progress, and the reason why the
/// last attempt was rejected.
struct GuideStep {
  std::string instruction = {};               // for the user, what to do now
  std::size_t index = 0, count = 1;           // steps done; total number of steps
  double progress = 0;                        // progress of this step, 0 to 1
  bool done = false;                          // all steps are done
  std::optional<Vec3> target = {};            // position to move to, m, room
  std::optional<Eigen::Vector2d> pixel = {};  // position of the cross in an eye's image, from the upper left
  std::string rejection = {};                 // reason why the last attempt was rejected; empty: no error
};

/// Returns the step of a guided calibration that has completed `index` of `count` steps, without its
/// instruction.
inline GuideStep step_at(std::size_t index, std::size_t count, const std::string& rejection = {}) {
  return {.index = index, .count = count, .done = index == count, .rejection = rejection};
}

struct GuideOutcome {
  std::vector<std::string> words;     // lines of text for the user
  std::vector<ConfigChange> changes;  // changes to the configuration
};

class Guide {
 public:
  virtual ~Guide() = default;
  virtual void take(const DeviceSample& sample) = 0;
  virtual GuideStep step() const = 0;
  /// Discards the result of the guided calibration's last step, so that the user repeats this step.
  virtual void back() = 0;
  /// Returns the result of the guided calibration: text lines for the user and changes to the configuration.
  /// Throws InputError that names the step to repeat if the result is bad.
  virtual GuideOutcome outcome() const = 0;
};

/// Converts a position (m) to a value for the configuration file: three numbers, rounded to micrometres.
ConfigValue written(const Vec3& place);
/// Converts an orientation to a value for the configuration file: the quaternion w, x, y, z, rounded to 1e-7.
ConfigValue written(const Quat& orientation);

/// Returns the name of a receiver's role in the configuration file: none, head, left, right, instrument or
/// tablet.
const char* role_name(StationRole role);
/// Returns the role whose receiver is used to touch points and to find tips in calibrations, unless the user
/// names another one. It is the instrument if the configuration assigns it a receiver, else the right hand.
StationRole pointer_role(const ClientConfig& config);
/// Returns the index (from 0) of the tracker's receiver that the configuration assigns to a role. Throws
/// InputError if there is none.
std::size_t station_of_role(const ClientConfig& config, StationRole role);

}  // namespace prosector
