#pragma once
// Hands without gloves, tracked by Ultraleap's cameras through the WebSocket of its service. The right hand
// is station 1, the left one station 2. Each has a pose, flexions and a gesture.

#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

#include "common/clock.h"
#include "drivers/device/gesture.h"
#include "drivers/device/health_monitor.h"
#include "drivers/device/pose_chain.h"
#include "drivers/ports/web_socket.h"
#include "drivers/protocols/leap_messages.h"

namespace prosector {

class LeapDevice final : public Device {
 public:
  /// Creates the driver of Ultraleap's hand tracking without connecting it to the service. `where` names the
  /// service in messages.
  LeapDevice(std::string where, const Placement& placement, const GestureThresholds& gestures);

  /// Starts the thread that communicates with Ultraleap's service at `host` and `port` by WebSocket.
  void connect_service(const std::string& host, const std::string& port);
  /// Processes a message of Ultraleap's service and returns the texts to answer. Returns nothing for an
  /// unknown protocol version; the connection is then closed. Only one thread may call it.
  std::optional<std::vector<std::string>> handle_text(std::string_view text);

  void poll(std::vector<DeviceSample>& out) override;
  DeviceStatus status() const override;
  int descriptor() const override { return -1; }

 private:
  struct Heard {
    std::int64_t time_ns = 0;
    std::size_t bytes = 0;
    std::optional<leap::Text> text;  // nothing: the text was unreadable
  };
  void take(const Heard& heard, std::vector<DeviceSample>& out);

  std::string where_;
  PoseChain chain_;
  std::mutex mutex_;
  std::deque<Heard> heard_;  // received texts, filled by the communication thread
  HealthMonitor health_;
  std::array<GestureDetector, 2> gestures_;
  std::array<std::uint64_t, 2> records_{};
  int version_ = leap::known_version;
  bool has_camera_ = true;  // according to the service's events and frames
  std::uint64_t connections_ = 0;
  WebSocket::State line_;
  std::unique_ptr<WebSocket> socket_;  // last member: its thread uses those above
};

/// Creates the driver of Ultraleap's hand tracking and starts to connect to its service. `path` is the
/// address after "leap:", such as "localhost:6437". Throws InputError unless it is HOST[:PORT].
std::unique_ptr<Device> open_leap(const std::string& path, const Placement& placement,
                                  const GestureThresholds& gestures);

}  // namespace prosector
