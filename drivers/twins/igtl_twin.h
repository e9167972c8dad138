#pragma once
// A simulated OpenIGTLink server with a tracker: its first station is told by TRANSFORM, the others by TDATA
// to a client that asks for it.

#include <random>

#include "drivers/igtl_messages.h"
#include "drivers/twins/tracker_clock.h"

namespace prosector {

class IgtlTwin final : public Twin {
 public:
  IgtlTwin(const TrackerTwinOptions& options, std::int64_t now_ns)
      : stations_(options.stations),
        bad_sums_(options.bad_sums),
        clock_(options, now_ns),
        random_(options.seed) {}

  void receive(std::span<const std::uint8_t> bytes, std::int64_t now_ns,
               std::vector<TwinOutput>& out) override;
  void produce(std::int64_t now_ns, std::vector<TwinOutput>& out) override;
  std::int64_t due_ns(std::int64_t) const override { return clock_.next_ns(); }
  void go_on(std::int64_t now_ns) override { clock_.go_on(now_ns); }
  void hung_up() override;

 private:
  igtl::Tool tool(std::size_t station, std::int64_t now_ns) const;
  void put(const igtl::Message& message, std::size_t station, const igtl::Tool& tool, std::int64_t now_ns,
           std::vector<TwinOutput>& out);

  std::size_t stations_;
  double bad_sums_;
  TrackerClock clock_;
  std::mt19937_64 random_;
  igtl::Reader reader_;
  bool tools_ = false;  // TDATA was asked for
  std::array<std::uint64_t, max_stations> records_{};
};

}  // namespace prosector
