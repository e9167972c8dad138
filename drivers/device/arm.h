#pragma once
// Interface of a haptic arm for the client: it reports the stylus pose and renders a force. The servo thread
// calls it about 1000 times a second (client/haptics/servo_thread.h).

#include <memory>
#include <string>

#include "drivers/device/device.h"

namespace prosector {

/// Limits of a haptic arm: workspace, force, stiffness, torque, and rate of its servo loop. Forces act at the
/// stylus origin, whose position the arm reports.
struct ArmLimits {
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();  // m, arm frame: corners of the workspace
  double peak_force = 0;                         // N, sustainable for seconds
  double continuous_force = 0;                   // N, sustainable for hours
  double stiffness = 0;                          // N/m: stiffest wall that the arm can render
  double max_slew = 0;                           // N/s
  double peak_torque = 0;                        // N·m, sustainable for hours; 0: the stylus rotation is not
                                                 // actuated
  double torsion = 0;                            // N·m/rad: stiffest torsion spring that the arm can render
  double rate = 1000;                            // Hz, of the servo loop
};

inline constexpr unsigned arm_buttons = 32;  // maximum number of buttons

/// One reading of a haptic arm: stylus pose, pressed buttons, motor temperature state, and whether the pose
/// is valid.
struct ArmReading {
  bool valid = false;         // the pose was read and the arm is homed and not being calibrated
  Pose stylus;                // pose in the room frame; −z towards the tip
  std::uint32_t buttons = 0;  // bit mask; bit 0 is the first button
  bool hot = false;           // a motor is near its thermal limit: reduce the force
  bool turns = false;         // the stylus rotation is actuated: set_torque() has an effect
};

class Arm {
 public:
  virtual ~Arm() = default;
  virtual const ArmLimits& limits() const = 0;
  /// Returns the arm's latest stylus pose and buttons without waiting. If the arm does not respond, the
  /// reading's `valid` is false.
  virtual ArmReading read() = 0;
  /// Sets the torque that the arm exerts on the hand about the stylus origin, N·m, room frame. It takes
  /// effect with the next force. The caller keeps it within the arm's limits. Arms whose readings do not set
  /// `turns` cannot exert torques and ignore it.
  virtual void set_torque([[maybe_unused]] const Vec3& torque) {}
  /// Sets the force that the arm exerts on the hand, N, room frame, until the next call. The caller keeps it
  /// within the arm's limits.
  virtual void set_force(const Vec3& force) = 0;
  /// Sets a force that varies linearly with the displacement from the last reading's position: force −
  /// stiffness·displacement (N, N/m, room frame). Arms with their own control loop render this field. Other
  /// arms apply `force` and ignore `stiffness`.
  virtual void set_field(const Vec3& force, [[maybe_unused]] const Mat3& stiffness) { set_force(force); }
  virtual DeviceStatus status() const = 0;
};

/// Pose of a haptic arm's base in the room.
struct ArmConfig {
  Pose room_arm;  // pose of the arm frame (x right, y up, z towards the user) in the room frame
};

/// One row of the table of haptic arm drivers: the name that begins an arm's address, the help text, and the
/// function that opens an arm.
struct ArmRow {
  const char* name;
  const char* help;  // one line for --help
  std::unique_ptr<Arm> (*open)(const std::string& path, const ArmConfig& config);
};
const std::vector<ArmRow>& arm_drivers();

/// Splits a haptic arm's address "DRIVER:PATH" into driver and path. Throws InputError for an unknown driver
/// (listing the known ones) or a missing path.
DeviceAddress parse_arm_address(const std::string& address);

/// Opens a haptic arm by its address, such as "omni-twin:/run/omni". Throws InputError for an unknown driver
/// (listing the known ones) or a missing path.
std::unique_ptr<Arm> open_arm(const std::string& address, const ArmConfig& config);

}  // namespace prosector
