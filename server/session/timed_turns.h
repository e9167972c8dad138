#pragma once
// Turns of a session in wall time, at the rate of its scene and the pace of its people.

#include <atomic>
#include <cstdint>
#include <functional>

namespace prosector {

struct TimedTurns {
  double tick_rate = 0;  // 1/s, of turns while simulated time is as fast as real time
  double seconds = 0;    // of wall time; 0: no end
  std::function<void()> turn;
  std::function<double()> pace;       // of simulated time, after a turn; 0: it stands still
  std::function<void()> each_second;  // after a turn
};

/// Takes turns until `stop`, or until the time is over. While simulated time stands still, turns come as
/// often as it would run. Returns how often a turn was too late to be caught up.
std::uint64_t take(const TimedTurns& turns, const std::atomic<bool>& stop);

}  // namespace prosector
