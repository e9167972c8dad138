#pragma once
// Driver for the PHANTOM Omni without a vendor SDK: finds the arm, homes it, reads its stylus and drives its
// motors.

#include <functional>
#include <memory>
#include <string>

#include "common/clock.h"
#include "drivers/arms/omni_arm_math.h"
#include "drivers/arms/omni_line.h"
#include "drivers/device/arm.h"

namespace prosector {

/// Returns the workspace, force and stiffness limits of a PHANTOM Omni according to its data sheet.
ArmLimits omni_limits();

class OmniArm final : public Arm {
 public:
  OmniArm(std::unique_ptr<omni::Line> line, const ArmConfig& config,
          std::function<std::int64_t()> clock = monotonic_ns);
  ~OmniArm() override;

  const ArmLimits& limits() const override { return limits_; }
  ArmReading read() override;
  void set_force(const Vec3& force) override;
  DeviceStatus status() const override;

 private:
  bool open(std::int64_t now_ns);
  void take(const omni::State& state, std::int64_t now_ns);
  ArmReading reading(std::int64_t now_ns) const;
  void lose();

  std::unique_ptr<omni::Line> line_;
  ArmConfig config_;
  ArmLimits limits_ = omni_limits();
  std::function<std::int64_t()> clock_;
  std::int64_t next_open_ns_ = 0, heard_ns_ = 0;
  std::optional<omni::State> last_;
  std::array<int, 3> counts_{}, home_{};  // encoder counts, unwrapped; counts in the dock
  bool homed_ = false, armed_ = false;
  bool last_packet_unreadable_ = false;  // the latest packet was unreadable
  omni::Joints joints_ = omni::docked;
  DeviceStatus status_;
};

/// Creates the driver of a PHANTOM Omni on a FireWire port. `port` is the port's number, such as "0" in the
/// address "omni:0".
std::unique_ptr<Arm> open_omni(const std::string& port, const ArmConfig& config);
/// Creates the driver of a simulated PHANTOM Omni. `path` is its Unix socket, such as "/run/user/1000/omni"
/// in the address "omni-twin:/run/user/1000/omni".
std::unique_ptr<Arm> open_omni_twin(const std::string& path, const ArmConfig& config);

}  // namespace prosector
