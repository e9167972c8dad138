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
  /// Sets the time of the recording that is displayed at `now` (s, monotonic clock); nullopt if the session
  /// is live.
  void see(const std::optional<ShownTime>& shown, double now);
  bool watches() const { return shown_.has_value(); }

  /// Handles a key press. Returns the command to the server, such as a seek or a change of speed; nullopt if
  /// the key does not control the playback.
  std::optional<CommandBody> press(Key key);
  /// Handles a press of the left mouse button at `at`, in points from the top left. On the time bar, returns
  /// the command to seek there and starts dragging; elsewhere returns nullopt.
  std::optional<CommandBody> press(const OverlayFrame& frame, const Eigen::Vector2d& at);
  /// Handles a motion of the pointer to `at`, in points from the top left. While the time bar is dragged,
  /// returns the command to seek there, at a limited rate; otherwise nullopt.
  std::optional<CommandBody> move(const OverlayFrame& frame, const Eigen::Vector2d& at);
  /// Handles the release of the left mouse button. If the time bar was dragged, returns the command to seek
  /// to the last position; otherwise nullopt.
  std::optional<CommandBody> let_go();

  /// Returns the tick of the recording to which the user has requested to jump and that is not displayed yet;
  /// nullopt if there is none.
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
