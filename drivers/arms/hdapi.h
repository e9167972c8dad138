#pragma once
// Driver for OpenHaptics arms (PHANTOM, Touch) through libHD.so, where that is installed.

#include <functional>
#include <future>
#include <memory>
#include <string>

#include "common/clock.h"
#include "drivers/arms/hdapi_session.h"
#include "drivers/device/arm.h"
#include "drivers/ports/background_opener.h"

namespace prosector {

class HdapiArm final : public Arm {
 public:
  /// Takes the part of the arm's address after the driver's name: "NAME" of the device, or "NAME@LIBRARY"
  /// with the file of the vendor's library. `opening` says how read() opens the device: `async` in another
  /// thread, `deferred` synchronously, for tests with simulated time.
  HdapiArm(const std::string& path, const ArmConfig& config, std::launch opening = std::launch::async,
           std::function<std::int64_t()> clock = monotonic_ns);

  const ArmLimits& limits() const override { return limits_; }
  ArmReading read() override;
  void set_force(const Vec3& force) override;
  DeviceStatus status() const override;

 private:
  std::string words() const;

  LibraryAddress address_;
  ArmConfig config_;
  ArmLimits limits_;
  std::function<std::int64_t()> clock_;
  ArmSample last_;
  DeviceStatus earlier_;  // counts of closed sessions
  BackgroundOpener<hdapi::Session> opening_;
};

/// Creates the driver of an OpenHaptics arm, given the part of its address after "hdapi:", such as "default".
std::unique_ptr<Arm> open_hdapi(const std::string& path, const ArmConfig& config);

}  // namespace prosector
