#pragma once
// Playback control of a recording with keys and the time bar.

#include <cstdint>
#include <optional>

#include "client/render/window_context.h"
#include "client/replica/shown_time.h"
#include "client/view/time_bar.h"
#include "common/commands.h"

namespace prosector {

class TimeControl {
 public:
  /// Sets the displayed time at `now`, s of a monotonic clock; nullopt: the session is live.
  void see(const std::optional<ShownTime>& shown, double now);
  bool watches() const { return shown_.has_value(); }

  /// Returns the command of a key; nullopt: it is no playback key.
  std::optional<CommandBody> press(Key key);
  /// Handles a press of the left button at `at`, points from the top left. Returns the command; nullopt if it
  /// is not on the bar.
  std::optional<CommandBody> press(const OverlayFrame& frame, const Eigen::Vector2d& at);
  /// Handles a motion of the pointer. Returns the command of a drag, rate-limited.
  std::optional<CommandBody> move(const OverlayFrame& frame, const Eigen::Vector2d& at);
  /// Handles the button's release. Returns the command for the end of a drag.
  std::optional<CommandBody> let_go();

  /// Returns the requested tick that is not displayed yet.
  std::optional<std::uint64_t> wish() const { return wish_; }

 private:
  std::optional<ShownTime> shown_;
  std::optional<std::uint64_t> wish_;
  bool drags_ = false;
  double now_ = 0, wished_at_ = 0, asked_at_ = 0;  // s

  CommandBody go_to(double tick);
  CommandBody go_by(double seconds);
  void wish_for(double tick);
};

}  // namespace prosector
