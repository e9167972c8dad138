#pragma once
// A simulated VRPN server with a tracker, and an analog device that reports finger flexions.

#include "drivers/protocols/vrpn_messages.h"
#include "twins/trackers/tracker_clock.h"

namespace prosector {

class VrpnTrackerTwin final : public Twin {
 public:
  VrpnTrackerTwin(std::string name, const TrackerTwinOptions& options, std::int64_t now_ns)
      : name_(std::move(name)), stations_(options.stations), clock_(options, now_ns) {}

  void receive(std::span<const std::uint8_t> bytes, std::int64_t now_ns,
               std::vector<TwinOutput>& out) override;
  void produce(std::int64_t now_ns, std::vector<TwinOutput>& out) override;
  std::int64_t due_ns(std::int64_t) const override { return clock_.next_ns(); }
  void go_on(std::int64_t now_ns) override { clock_.go_on(now_ns); }
  void reset_client() override;

 private:
  std::string name_;
  std::size_t stations_;
  TrackerClock clock_;
  vrpn::Reader reader_;
  bool named_ = false;
  std::array<std::uint64_t, max_stations> records_{};
};

}  // namespace prosector
