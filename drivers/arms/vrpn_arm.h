#pragma once
// Driver for an arm of a VRPN server, as many laboratories have one: a tracker, buttons and a force device
// with one name. The server closes the arm's control loop, so the driver sends a linear force field instead
// of a constant force.

#include <functional>
#include <future>
#include <memory>
#include <string>

#include "common/clock.h"
#include "drivers/device/arm.h"
#include "drivers/ports/background_opener.h"
#include "drivers/ports/byte_line.h"
#include "drivers/protocols/vrpn_messages.h"

namespace prosector {

class VrpnArm final : public Arm {
 public:
  /// Takes the arm's name on the VRPN server and a function that connects to this server. `opening` says how
  /// read() connects: `async` in another thread, `deferred` synchronously, for tests with simulated time.
  VrpnArm(std::string name, const ArmConfig& config, std::function<std::unique_ptr<ByteStream>()> connect,
          std::launch opening = std::launch::async, std::function<std::int64_t()> clock = monotonic_ns);
  ~VrpnArm() override;

  const ArmLimits& limits() const override { return limits_; }
  ArmReading read() override;
  void set_force(const Vec3& force) override { set_field(force, Mat3::Zero()); }
  void set_field(const Vec3& force, const Mat3& stiffness) override;
  DeviceStatus status() const override;

 private:
  void greet(ByteStream& line);
  void take(const vrpn::Message& message, std::int64_t now_ns);
  void lose(std::string why, std::int64_t now_ns);

  std::string name_;
  ArmConfig config_;
  ArmLimits limits_;
  std::function<std::int64_t()> clock_;
  bool greeted_ = false;
  vrpn::Reader reader_;
  vrpn::Bytes bytes_;
  ArmReading last_;  // the stylus pose is in the arm frame
  std::int64_t heard_ns_ = 0, last_pose_ns_ = 0, hot_until_ns_ = 0;
  DeviceStatus counts_;
  BackgroundOpener<ByteStream> opening_;
};

/// Creates the driver of a VRPN server's arm. `path` is the address after "vrpn:", such as
/// "Phantom0@lab:3883". Throws InputError unless it is NAME@HOST[:PORT].
std::unique_ptr<Arm> open_vrpn(const std::string& path, const ArmConfig& config);

}  // namespace prosector
