#pragma once
// Simulated time of a session on a client: received, displayed, and its pace.

#include <algorithm>
#include <cstdint>
#include <optional>

#include "client/replica/playout_clock.h"
#include "common/ids.h"

namespace prosector {

class SessionTime {
 public:
  /// Sets the server's ticks per second of simulated time. The first call starts the displayed time's clock.
  void set_tick_rate(double tick_rate) {
    tick_seconds_ = 1 / tick_rate;
    if (!clock_) clock_.emplace(tick_rate).set_pace(pace_);
  }
  /// Sets the ratio of simulated to real time; 0: paused.
  void set_pace(double pace) {
    pace_ = pace;
    if (clock_) clock_->set_pace(pace);
  }
  /// Notes that a state of this simulated time arrived at the monotonic time `arrival_ns`.
  void arrived(const SimTime& time, std::int64_t arrival_ns) {
    newest_ = std::max(newest_, time);
    if (clock_) clock_->arrived(time, arrival_ns);
  }
  /// Advances the playhead, the displayed time, to the monotonic time `now_ns`. Returns the tick (simulation
  /// step, with a fraction) to display.
  double advance(std::int64_t now_ns) { return clock_ ? clock_->playhead(now_ns) : 0; }

  /// Returns the time of the newest received state.
  const SimTime& newest() const { return newest_; }
  /// Returns the tick (simulation step) that is displayed for a playhead at `tick`. It is limited to the tick
  /// of the newest received state.
  double shown_tick(double tick) const { return std::min(tick, static_cast<double>(newest_.tick)); }
  /// Returns the ratio of simulated to real time that the host has set; 0 while the session is paused.
  double pace() const { return pace_; }
  double tick_seconds() const { return tick_seconds_; }
  double playout_delay_ms() const { return clock_ ? clock_->delay_ms() : 0; }

 private:
  std::optional<PlayoutClock> clock_;  // nullopt: the tick rate was not received yet
  SimTime newest_;
  double tick_seconds_ = 1.0 / 60;  // until the tick rate is received
  double pace_ = 1;
};

}  // namespace prosector
