#pragma once
// Decides which simulated time to draw now: as late as the network's jitter asks, as early as it allows,
// never jumping.
//
// Every sample says at which tick it was made and when it arrived. The smallest (arrival − tick·dt) of the
// last second is the fastest way through the network; what others exceed it by is jitter. The playhead runs
// that far, plus one tick, behind. When the server slows simulated time the offset grows, and the playhead
// slows with it.

#include <cstdint>
#include <deque>

#include "common/messages.h"

namespace prosector {

class PlayoutClock {
 public:
  explicit PlayoutClock(double tick_rate) : dt_(1 / tick_rate) {}

  void arrived(const SimTime& time, std::int64_t arrival_ns);
  /// Tick (with fraction) to draw at `now_ns`; monotonic within an epoch. 0 before anything arrived.
  double playhead(std::int64_t now_ns);
  double delay_ms() const { return 1e3 * delay_; }

 private:
  struct Offset {
    std::int64_t arrival_ns;
    double seconds;
  };
  double dt_;
  std::uint32_t epoch_ = 0;
  std::deque<Offset> offsets_;  // of the last second
  double delay_ = 0;            // s behind the fastest sample
  double playhead_ = 0;         // s of simulated time
  std::int64_t last_ns_ = 0;
};

}  // namespace prosector
