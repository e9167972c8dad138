#pragma once
// Arms of Force Dimension (omega, delta, sigma, lambda), behind libdhd.so where that is installed. The
// library has no servo of its own: its calls take a frame of USB at most, so the client's servo makes them.

#include <functional>
#include <future>
#include <memory>
#include <string>

#include "common/clock.h"
#include "drivers/arm.h"
#include "drivers/dhd_library.h"
#include "drivers/opening.h"

namespace prosector {

/// Returns what any of these arms can do, by the data sheets of the omega.3 and, of torque, of the sigma.7.
/// How hard a turn a sigma.7 shows isn't in its sheet, and assumed.
ArmLimits dhd_limits();

namespace dhd {

/// A device from its opening to its closing.
class Session {
 public:
  /// Opens a device by number ("default": the first one) and lets it have forces. Throws InputError saying
  /// what is missing.
  explicit Session(const LibraryAddress& address);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  const Api& api() const { return api_; }
  char id() const { return id_; }
  /// Tells whether motors turn its stylus.
  bool turns() const { return turns_; }

 private:
  Api api_;
  char id_ = 0;
  bool turns_ = false;
};

}  // namespace dhd

class DhdArm final : public Arm {
 public:
  /// Takes the address behind the driver's name, "ID" or "ID@LIBRARY". `opening`: deferred opens in read(),
  /// for tests in their own time.
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
  int failed_ = 0;              // calls in a row
  std::uint64_t cycles_ = 0;
  bool resting_ = false;  // it is being calibrated
  bool free_ = true;      // it lets itself have forces …
  bool begins_ = false;   // … since just now: force begins at nothing
  DeviceStatus counts_;
  std::string condition_;  // what people are to know of the device that is open
  Opening<dhd::Session> opening_;
};

/// Opens an arm of Force Dimension, "dhd:0".
std::unique_ptr<Arm> open_dhd(const std::string& path, const ArmConfig& config);

}  // namespace prosector
