#pragma once
// How a person has the time of a recording in hand: with keys, and by its bar.

#include <cstdint>
#include <optional>

#include "client/render/window_context.h"
#include "client/replica/shown_time.h"
#include "client/view/time_bar.h"
#include "common/messages.h"

namespace prosector {

class TimeControl {
 public:
  /// Takes what is shown at `now`, s of a clock that never goes back; nullopt: no recording is watched.
  void see(const std::optional<ShownTime>& shown, double now);
  bool watches() const { return shown_.has_value(); }

  /// Returns what a key asks for; nullopt: nothing of time.
  std::optional<Command> press(Key key);
  /// Takes that the left button goes down, `at` points from the top left. Returns what is asked for; nullopt:
  /// the bar is elsewhere.
  std::optional<Command> press(const OverlayFrame& frame, const Eigen::Vector2d& at);
  /// Takes that the pointer moves; returns what a drag asks for, not too often.
  std::optional<Command> move(const OverlayFrame& frame, const Eigen::Vector2d& at);
  /// Takes that the button is let go; returns where a drag ends.
  std::optional<Command> let_go();

  /// Returns the tick that was asked for and is not shown yet.
  std::optional<std::uint64_t> wish() const { return wish_; }

 private:
  std::optional<ShownTime> shown_;
  std::optional<std::uint64_t> wish_;
  bool drags_ = false;
  double now_ = 0, wished_at_ = 0, asked_at_ = 0;  // s

  Command go_to(double tick);
  Command go_by(double seconds);
  void wish_for(double tick);
};

}  // namespace prosector
