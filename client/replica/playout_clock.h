#pragma once
// Decides which simulated time to draw now: as late as the network's jitter asks, as early as it allows,
// never jumping.
//
// Every sample says at which tick it was made and when it arrived. Over the last second, simulated time
// against arrival makes a line, of slope 1, or less when the server slows simulated time, or more where a
// recording is played faster. The sample that lies
// farthest below it is jitter: the playhead runs that far, plus one tick, behind the line.

#include <cstdint>
#include <deque>

#include "common/messages.h"

namespace prosector {

class PlayoutClock {
 public:
  explicit PlayoutClock(double tick_rate) : dt_(1 / tick_rate) {}

  /// Takes how many simulated seconds go by in a real one, as people have it; it may be less.
  void set_pace(double pace) { pace_ = pace; }
  void arrived(const SimTime& time, std::int64_t arrival_ns);
  /// Returns the tick (with fraction) to draw at `now_ns`; monotonic within an epoch. 0 before anything
  /// arrived.
  double playhead(std::int64_t now_ns);
  double delay_ms() const { return 1e3 * delay_; }

 private:
  struct Sample {
    std::int64_t arrival_ns;
    double simulated;  // s
  };
  double dt_, pace_ = 1;
  std::uint32_t epoch_ = 0;
  std::deque<Sample> samples_;  // of the last second
  double delay_ = 0;            // s behind the line
  double playhead_ = 0;         // s of simulated time
  std::int64_t last_ns_ = 0;

  double slope() const;
};

}  // namespace prosector
