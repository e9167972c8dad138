#pragma once
// An arm at a VRPN server, as many laboratories have one: a tracker, buttons and a force device of one name.
// The server closes the arm's own loop, so it is told how force changes around a place, not only a force.

#include <functional>
#include <future>
#include <memory>
#include <string>

#include "common/clock.h"
#include "drivers/arm.h"
#include "drivers/byte_line.h"
#include "drivers/opening.h"
#include "drivers/vrpn_messages.h"

namespace prosector {

class VrpnArm final : public Arm {
 public:
  /// Takes the device's name and what opens a line to its server. `opening`: deferred opens in read(), for
  /// tests in their own time.
  VrpnArm(std::string name, const ArmConfig& config, std::function<std::unique_ptr<ByteLine>()> connect,
          std::launch opening = std::launch::async, std::function<std::int64_t()> clock = monotonic_ns);
  ~VrpnArm() override;

  const ArmLimits& limits() const override { return limits_; }
  ArmReading read() override;
  void set_force(const Vec3& force) override { set_field(force, Mat3::Zero()); }
  void set_field(const Vec3& force, const Mat3& stiffness) override;
  DeviceStatus status() const override;

 private:
  void greet(ByteLine& line);
  void take(const vrpn::Message& message, std::int64_t now_ns);
  void lose(std::string why, std::int64_t now_ns);

  std::string name_;
  ArmConfig config_;
  ArmLimits limits_;
  std::function<std::int64_t()> clock_;
  bool greeted_ = false;
  vrpn::Reader reader_;
  vrpn::Bytes bytes_;
  ArmReading last_;  // its stylus is in the arm's frame
  std::int64_t heard_ns_ = 0, posed_ns_ = 0, hot_until_ns_ = 0;
  DeviceStatus counts_;
  Opening<ByteLine> opening_;
};

/// Opens an arm at a server, "vrpn:Phantom0@lab:3883". Throws InputError for what is no NAME@HOST[:PORT].
std::unique_ptr<Arm> open_vrpn(const std::string& path, const ArmConfig& config);

}  // namespace prosector
