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
  /// Takes the address after the driver's name, "NAME" or "NAME@LIBRARY". `opening`: deferred opens the
  /// device synchronously in read(), for tests with simulated time.
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

/// Opens an OpenHaptics arm, "hdapi:default".
std::unique_ptr<Arm> open_hdapi(const std::string& path, const ArmConfig& config);

}  // namespace prosector
