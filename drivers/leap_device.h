#pragma once
// Hands without gloves, as Ultraleap's cameras see them, by the WebSocket of its service: the right hand is
// station 1, the left one station 2. Each has a pose, bends and a gesture.

#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

#include "common/clock.h"
#include "drivers/gesture.h"
#include "drivers/health_monitor.h"
#include "drivers/leap_messages.h"
#include "drivers/pose_chain.h"
#include "drivers/web_socket.h"

namespace prosector {

class LeapDevice final : public Device {
 public:
  /// Makes one that nobody talks for yet. `where` is for people.
  LeapDevice(std::string where, const DeviceConfig& config);

  /// Lets a thread talk to the service there.
  void talk_to(const std::string& host, const std::string& port);
  /// Takes what the service says. Returns the answers; nothing to one of another version, which is left. One
  /// thread calls it.
  std::optional<std::vector<std::string>> hear(std::string_view text);

  void poll(std::vector<DeviceSample>& out) override;
  DeviceStatus status() const override;
  int descriptor() const override { return -1; }

 private:
  struct Heard {
    std::int64_t time_ns = 0;
    std::size_t bytes = 0;
    std::optional<leap::Text> text;  // nothing: it could not be read
  };
  void take(const Heard& heard, std::vector<DeviceSample>& out);

  std::string where_;
  PoseChain chain_;
  std::mutex mutex_;
  std::deque<Heard> heard_;  // by the thread that talks
  HealthMonitor health_;
  std::array<GestureDetector, 2> gestures_;
  std::array<std::uint64_t, 2> records_{};
  int version_ = leap::known_version;
  bool has_camera_ = true;  // as far as the service's events say
  std::uint64_t connections_ = 0;
  WebSocket::State line_;
  std::unique_ptr<WebSocket> socket_;  // last: its thread uses what is above
};

/// Opens hands at a service, "leap:localhost:6437". Throws InputError for what is no HOST[:PORT].
std::unique_ptr<Device> open_leap(const std::string& path, const DeviceConfig& config);

}  // namespace prosector
