#pragma once
// Computes the simulated time to display: delayed as much as the network's jitter requires, and no more,
// without jumps.
//
// Every sample has a tick and an arrival time. Over the last second, simulated time against arrival time
// forms a line of slope 1; less when the server slows simulated time, more when a recording is played faster.
// The sample farthest below the line gives the jitter: the playhead is delayed by that, plus one tick.

#include <cstdint>
#include <deque>

#include "common/ids.h"

namespace prosector {

class PlayoutClock {
 public:
  explicit PlayoutClock(double tick_rate) : dt_(1 / tick_rate) {}

  /// Sets the nominal ratio of simulated to real time, for instance that set by the host. The actual ratio
  /// may be less if the server is too slow.
  void set_pace(double pace) { pace_ = pace; }
  void arrived(const SimTime& time, std::int64_t arrival_ns);
  /// Returns the tick (simulation step, with a fraction) to display at the monotonic time `now_ns`. It never
  /// decreases until the server rewinds. Returns 0 before the first sample.
  double playhead(std::int64_t now_ns);
  double delay_ms() const { return 1e3 * delay_; }

 private:
  struct Sample {
    std::int64_t arrival_ns;
    double simulated;  // simulated time, s
  };
  double dt_, pace_ = 1;
  std::uint32_t epoch_ = 0;
  std::deque<Sample> samples_;  // of the last second
  double delay_ = 0;            // s of delay behind the line
  double playhead_ = 0;         // s of simulated time
  std::int64_t last_ns_ = 0;

  double slope() const;
};

}  // namespace prosector
