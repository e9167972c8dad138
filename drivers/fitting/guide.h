#pragma once
// A calibration as a person goes through it: samples in, out what to do next, and in the end what came out.
// Neither a window nor a terminal is known here; both show guides.

#include <optional>
#include <string>
#include <vector>

#include "drivers/client_config_write.h"
#include "drivers/device.h"

namespace prosector {

/// Where a person is in a calibration.
struct GuideStep {
  std::string instruction;               // what to do now
  std::size_t index = 0, count = 1;      // steps that are done, of all
  double progress = 0;                   // of this step, 0 to 1
  bool done = false;                     // all steps are
  std::optional<Vec3> target;            // where to go, m, room
  std::optional<Eigen::Vector2d> pixel;  // where a cross is shown in an eye's picture, from the upper left
  std::string trouble;                   // why the last try didn't count; empty: nothing is wrong
};

struct GuideOutcome {
  std::vector<std::string> words;     // lines for people
  std::vector<ConfigChange> changes;  // of the configuration
};

class Guide {
 public:
  virtual ~Guide() = default;
  virtual void take(const DeviceSample& sample) = 0;
  virtual GuideStep step() const = 0;
  /// Drops what the last step gave, so that it is done again.
  virtual void back() = 0;
  /// Returns what came out. Throws InputError that says what to do again where nothing good did.
  virtual GuideOutcome outcome() const = 0;
};

/// Returns a place for the configuration, rounded to micrometres.
ConfigValue written(const Vec3& place);
/// Returns an orientation for the configuration (w, x, y, z), rounded to 1e-7.
ConfigValue written(const Quat& orientation);

/// Returns the name of a role in the configuration: head, right, left, instrument.
const char* role_name(StationRole role);
/// Returns whose receiver touches and swings, unless another one is named: the instrument's where there is
/// one, else the right hand's.
StationRole touching_role(const ClientConfig& config);
/// Returns the receiver (from 0) that has a role. Throws InputError where none has.
std::size_t station_with_role(const ClientConfig& config, StationRole role);

}  // namespace prosector
