#pragma once
// Displayed time of a recording.

#include <cstdint>
#include <optional>

#include "client/replica/replica.h"

namespace prosector {

struct ShownTime {
  std::uint64_t last_tick = 0;
  double tick = 0;
  double tick_rate = 60;  // Hz
  double pace = 1;        // ratio of simulated to real time; 0: paused
};

/// Returns the displayed time, length and pace of the recording that the server replays, for a playhead at
/// `tick`. Returns nullopt if the session is live.
inline std::optional<ShownTime> shown_time(const Replica& replica, double tick) {
  if (!replica.recording()) return std::nullopt;
  return ShownTime{replica.recording()->last_tick, replica.time().shown_tick(tick),
                   1 / replica.time().tick_seconds(), replica.time().pace()};
}

}  // namespace prosector
