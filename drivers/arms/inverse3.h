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

/// Returns the limits of an Inverse3; the forces are assumed (docs/do/arms.md).
ArmLimits inverse3_limits();

class Inverse3Arm final : public Arm {
 public:
  /// Creates an arm that is not connected yet.
  explicit Inverse3Arm(const ArmConfig& config, std::function<std::int64_t()> clock = monotonic_ns);

  /// Starts the thread that communicates with the service at `host` and `port`.
  void connect_service(const std::string& host, const std::string& port);
  /// Processes a message of the service and returns the answer. Only one thread calls it.
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

/// Opens an arm by its service, "inverse3:localhost:10001". Throws InputError for an address that is not
/// HOST:PORT.
std::unique_ptr<Arm> open_inverse3(const std::string& path, const ArmConfig& config);

}  // namespace prosector
