#pragma once
// Arms that OpenHaptics drives (PHANTOM, Touch), behind libHD.so where that is installed.

#include <functional>
#include <future>
#include <memory>
#include <string>

#include "common/clock.h"
#include "drivers/arm.h"
#include "drivers/hdapi_session.h"
#include "drivers/opening.h"

namespace prosector {

class HdapiArm final : public Arm {
 public:
  /// Takes the address behind the driver's name, "NAME" or "NAME@LIBRARY". `opening`: deferred opens in
  /// read(), for tests in their own time.
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
  DeviceStatus earlier_;  // counts of sessions that are over
  Opening<hdapi::Session> opening_;
};

/// Opens an arm of OpenHaptics, "hdapi:default".
std::unique_ptr<Arm> open_hdapi(const std::string& path, const ArmConfig& config);

}  // namespace prosector
