#pragma once
// A haptic arm as the client sees it: it says where its stylus is, and takes a force. Its own thread calls
// it, about a thousand times a second (client/haptics/servo_thread.h).

#include <string>

#include "drivers/device.h"

namespace prosector {

/// What an arm can do. Forces are those at its tip.
struct ArmLimits {
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();  // m, arm's frame: corners of its workspace
  double peak_force = 0;                         // N, for seconds
  double continuous_force = 0;                   // N, for hours
  double stiffness = 0;                          // N/m: of the hardest wall that it shows
  double max_slew = 0;                           // N/s
  double peak_torque = 0;                        // N·m, for hours; 0: no motors turn the stylus
  double torsion = 0;                            // N·m/rad: of the hardest turn that it shows
  double rate = 1000;                            // Hz, of its servo loop
};

inline constexpr unsigned arm_buttons = 32;  // at most

/// One reading of the arm.
struct ArmReading {
  bool valid = false;         // the pose was read and the arm knows where it is (homed, not being calibrated)
  Pose stylus;                // in the room; −z towards the tip
  std::uint32_t buttons = 0;  // the first one's bit is 1
  bool hot = false;           // a motor is near its limit: less force must do
  bool turns = false;         // motors turn the stylus: torque acts
};

class Arm {
 public:
  virtual ~Arm() = default;
  virtual const ArmLimits& limits() const = 0;
  /// Reads the arm and waits for nothing: what doesn't answer gives a reading that isn't valid.
  virtual ArmReading read() = 0;
  /// Sets the torque on the hand about the stylus' point, N·m, room frame, which acts from the next force on.
  /// It is within the limits. Arms whose readings don't say that they turn it have none.
  virtual void set_torque([[maybe_unused]] const Vec3& torque) {}
  /// Sets the force on the hand, N, room frame, until the next call. It is within the limits.
  virtual void set_force(const Vec3& force) = 0;
  /// Sets a force that changes with the way from where the last reading was: force − stiffness·way (N, N/m,
  /// room frame). Arms that close a loop of their own render that; others hold the force.
  virtual void set_field(const Vec3& force, [[maybe_unused]] const Mat3& stiffness) { set_force(force); }
  virtual DeviceStatus status() const = 0;
};

/// How an arm stands in the room.
struct ArmConfig {
  Pose room_arm;  // pose of the arm's frame (x right, y up, z towards the user) in the room
};

/// One row of the table of arms.
struct ArmRow {
  const char* name;
  const char* help;  // one line for --help
  std::unique_ptr<Arm> (*open)(const std::string& path, const ArmConfig& config);
};
const std::vector<ArmRow>& arm_drivers();

/// Splits an arm's address. Throws InputError for an unknown driver (listing the known ones) or a missing
/// path.
DeviceAddress parse_arm_address(const std::string& address);

/// Opens an arm by its address, "omni-twin:/run/omni". Throws InputError for an unknown driver (listing the
/// known ones) or a missing path.
std::unique_ptr<Arm> open_arm(const std::string& address, const ArmConfig& config);

}  // namespace prosector
