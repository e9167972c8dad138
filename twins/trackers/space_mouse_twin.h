#pragma once
// A simulated spacenavd. Its cap deflections move a hand along the script's trajectory, starting at the
// script's first position.

#include "drivers/protocols/space_mouse_records.h"
#include "twins/trackers/tracker_clock.h"

namespace prosector {

class SpaceMouseTwin final : public Twin {
 public:
  SpaceMouseTwin(const TrackerTwinOptions& options, std::int64_t now_ns) : clock_(options, now_ns) {}

  void receive(std::span<const std::uint8_t>, std::int64_t, std::vector<TwinOutput>&) override {}
  void produce(std::int64_t now_ns, std::vector<TwinOutput>& out) override;
  std::int64_t due_ns(std::int64_t) const override { return clock_.next_ns(); }
  void go_on(std::int64_t now_ns) override { clock_.go_on(now_ns); }

 private:
  TrackerClock clock_;
  std::optional<Vec3> before_;
  std::int64_t before_ns_ = 0;
  std::uint64_t records_ = 0;
};

}  // namespace prosector
