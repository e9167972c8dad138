#pragma once
// Driver for Haply's Inverse3 through its service. A separate thread communicates with the service and
// answers each state with the latest force.

#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "common/clock.h"
#include "drivers/arms/arm_exchange.h"
#include "drivers/device/arm.h"
#include "drivers/ports/web_socket.h"
#include "drivers/protocols/inverse3_messages.h"

namespace prosector {

/// Returns the limits of Haply's haptic arm Inverse3. Its forces are assumed values (docs/do/arms.md).
ArmLimits inverse3_limits();

class Inverse3Arm final : public Arm {
 public:
  /// Creates the driver of an Inverse3 haptic arm without connecting it to Haply's service. `clock` returns
  /// the time in ns.
  explicit Inverse3Arm(const ArmConfig& config, std::function<std::int64_t()> clock = monotonic_ns);

  /// Starts the thread that communicates with Haply's service at `host` and `port` by WebSocket.
  void connect_service(const std::string& host, const std::string& port);
  /// Processes a state message of Haply's service and returns the answer to send, which contains the latest
  /// force. Only one thread may call it.
  std::string handle_text(std::string_view text);

  const ArmLimits& limits() const override { return limits_; }
  ArmReading read() override;
  void set_force(const Vec3& force) override;
  DeviceStatus status() const override;

 private:
  ArmConfig config_;
  ArmLimits limits_ = inverse3_limits();
  std::function<std::int64_t()> clock_;
  ArmExchange exchange_;
  // Used by the communication thread only:
  ArmSample heard_;
  // Used by the servo thread only:
  ArmSample last_;
  WebSocket::State line_;
  std::unique_ptr<WebSocket> socket_;  // last member: its thread uses those above
};

/// Creates the driver of an Inverse3 arm and starts to connect to Haply's service. `path` is the address
/// after "inverse3:", such as "localhost:10001". Throws InputError unless it is HOST:PORT.
std::unique_ptr<Arm> open_inverse3(const std::string& path, const ArmConfig& config);

}  // namespace prosector
