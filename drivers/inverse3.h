#pragma once
// Haply's Inverse3, by the service that comes with it: a thread of its own talks to that, and answers each
// state with the newest force.

#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "common/clock.h"
#include "drivers/arm.h"
#include "drivers/arm_exchange.h"
#include "drivers/inverse3_messages.h"
#include "drivers/web_socket.h"

namespace prosector {

/// Returns what an Inverse3 can do; forces are assumed (docs/do/arms.md).
ArmLimits inverse3_limits();

class Inverse3Arm final : public Arm {
 public:
  /// Makes one that nobody talks for yet.
  explicit Inverse3Arm(const ArmConfig& config, std::function<std::int64_t()> clock = monotonic_ns);

  /// Lets a thread talk to the service there.
  void talk_to(const std::string& host, const std::string& port);
  /// Takes what the service says. Returns the answer. One thread calls it.
  std::string hear(std::string_view text);

  const ArmLimits& limits() const override { return limits_; }
  ArmReading read() override;
  void set_force(const Vec3& force) override;
  DeviceStatus status() const override;

 private:
  ArmConfig config_;
  ArmLimits limits_ = inverse3_limits();
  std::function<std::int64_t()> clock_;
  ArmExchange exchange_;
  // What the thread that talks alone touches:
  ArmSample heard_;
  // What the servo's thread alone touches:
  ArmSample last_;
  WebSocket::State line_;
  std::unique_ptr<WebSocket> socket_;  // last: its thread uses what is above
};

/// Opens an arm by its service, "inverse3:localhost:10001". Throws InputError for what is no HOST:PORT.
std::unique_ptr<Arm> open_inverse3(const std::string& path, const ArmConfig& config);

}  // namespace prosector
