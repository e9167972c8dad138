#pragma once
// A simulated OpenIGTLink server with a tracker. It sends its first station as TRANSFORM, and the others as
// TDATA to a client that requested it.

#include <random>

#include "drivers/protocols/igtl_messages.h"
#include "twins/trackers/tracker_clock.h"

namespace prosector {

class IgtlTwin final : public Twin {
 public:
  IgtlTwin(const TrackerTwinOptions& options, std::int64_t now_ns)
      : stations_(options.stations),
        bad_checksum_fraction_(options.bad_checksum_fraction),
        clock_(options, now_ns),
        random_(options.seed) {}

  void receive(std::span<const std::uint8_t> bytes, std::int64_t now_ns,
               std::vector<TwinOutput>& out) override;
  void produce(std::int64_t now_ns, std::vector<TwinOutput>& out) override;
  std::int64_t due_ns(std::int64_t) const override { return clock_.next_ns(); }
  void go_on(std::int64_t now_ns) override { clock_.go_on(now_ns); }
  void reset_client() override;

 private:
  igtl::Tool tool(std::size_t station, std::int64_t now_ns) const;
  void put(const igtl::Message& message, std::size_t station, const igtl::Tool& tool, std::int64_t now_ns,
           std::vector<TwinOutput>& out);

  std::size_t stations_;
  double bad_checksum_fraction_;
  TrackerClock clock_;
  std::mt19937_64 random_;
  igtl::Reader reader_;
  bool tools_ = false;  // the client requested TDATA
  std::array<std::uint64_t, max_stations> records_{};
};

}  // namespace prosector
