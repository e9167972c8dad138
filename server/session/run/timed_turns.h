#pragma once
// Runs a session's turns in wall time, at the rate of its scene and the pace that participants set.

#include <atomic>
#include <cstdint>
#include <functional>

namespace prosector {

struct TimedTurns {
  double tick_rate = 0;  // 1/s, of turns at real-time pace
  double seconds = 0;    // of wall time; 0: no end
  std::function<void()> turn;
  std::function<double()> pace;       // returns the pace of simulated time, after a turn; 0: stopped
  std::function<void()> each_second;  // called each second, after a turn
};

/// Runs turns (ticks of the session, or only message processing) until `stop` is true, or `seconds` of wall
/// time have passed. While simulated time is stopped, turns continue at the scene's rate. Returns how often a
/// turn was too late to be caught up.
std::uint64_t take(const TimedTurns& turns, const std::atomic<bool>& stop);

}  // namespace prosector
