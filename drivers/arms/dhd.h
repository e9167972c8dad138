#pragma once
// Driver for Force Dimension arms (omega, delta, sigma, lambda) through libdhd.so, where that is installed.
// The library has no servo thread. Its calls take one USB frame at most, so the client's servo makes them.

#include <functional>
#include <future>
#include <memory>
#include <string>

#include "common/clock.h"
#include "drivers/arms/dhd_library.h"
#include "drivers/device/arm.h"
#include "drivers/ports/background_opener.h"

namespace prosector {

/// Returns the limits assumed for all arms of Force Dimension. They are those of the omega.3's data sheet,
/// with the torque of the sigma.7. The torsional stiffness is not in the sigma.7's data sheet and is assumed.
ArmLimits dhd_limits();

namespace dhd {

/// One open haptic device of Force Dimension's library DHD. Its destructor sets the force to zero and closes
/// the device.
class Session {
 public:
  /// Opens a Force Dimension device by its number, or the first one for "default", and enables its forces.
  /// Throws InputError with the reason on failure.
  explicit Session(const LibraryAddress& address);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  const Api& api() const { return api_; }
  char id() const { return id_; }
  /// Returns whether motors drive the stylus rotation, so that the device can exert torques.
  bool turns() const { return turns_; }

 private:
  Api api_;
  char id_ = 0;
  bool turns_ = false;
};

}  // namespace dhd

class DhdArm final : public Arm {
 public:
  /// Takes the part of the arm's address after the driver's name: "ID" of the device, or "ID@LIBRARY" with
  /// the file of the vendor's library. `opening` says how read() opens the device: `async` in another thread,
  /// `deferred` synchronously, for tests with simulated time.
  DhdArm(const std::string& path, const ArmConfig& config, std::launch opening = std::launch::async,
         std::function<std::int64_t()> clock = monotonic_ns);

  const ArmLimits& limits() const override { return limits_; }
  ArmReading read() override;
  void set_torque(const Vec3& torque) override { torque_ = torque; }
  void set_force(const Vec3& force) override;
  DeviceStatus status() const override;

 private:
  bool ask(const dhd::Session& session, ArmReading& out);
  void look(const dhd::Session& session);

  LibraryAddress address_;
  ArmConfig config_;
  ArmLimits limits_ = dhd_limits();
  std::function<std::int64_t()> clock_;
  Vec3 torque_ = Vec3::Zero();  // N·m, room frame
  int failed_ = 0;              // consecutive failed calls
  std::uint64_t cycles_ = 0;
  bool resting_ = false;  // the device is being calibrated
  bool free_ = true;      // forces are enabled
  bool begins_ = false;   // forces were just enabled: the next reading is not valid, so that the force
                          // restarts from zero
  DeviceStatus counts_;
  std::string condition_;  // message about the open device for the user
  BackgroundOpener<dhd::Session> opening_;
};

/// Creates the driver of a Force Dimension arm, given the part of its address after "dhd:", such as "0".
std::unique_ptr<Arm> open_dhd(const std::string& path, const ArmConfig& config);

}  // namespace prosector
