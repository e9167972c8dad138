#pragma once
// The time bar at the lower border while a recording is played: its length, the current time, and event
// marks. In points (OverlayFrame).

#include <cstdint>
#include <optional>
#include <string>

#include "client/language/catalogue.h"
#include "client/view/draw_list.h"
#include "client/view/overlay_frame.h"
#include "common/recording_messages.h"

namespace prosector {

/// Height, in points, of the strip at the view's lower border that is reserved for the time bar of a
/// recording.
inline constexpr double time_bar_strip = 30;

/// Layout of a recording's time bar in a view: converts between ticks of the recording and positions in
/// points.
class TimeBar {
 public:
  /// Lays out the time bar at the lower border of the view. `last_tick`: length of the recording in ticks.
  TimeBar(const OverlayFrame& frame, std::uint64_t last_tick);

  double left() const { return left_; }
  double right() const { return right_; }
  double middle() const { return middle_; }  // of its height, points from the top
  /// Returns the horizontal position of a tick on the time bar, points from the view's left.
  double place_of(double tick) const;
  /// Returns the tick at the position `x` on the time bar, points from the view's left, limited to the
  /// recording.
  std::uint64_t tick_at(double x) const;
  /// Returns whether a position, in points from the view's top left, is on the time bar.
  bool is_on(const Eigen::Vector2d& at) const;

 private:
  double left_, right_, middle_;  // points
  double last_tick_;
};

/// State of the playback of a recording that the time bar shows.
struct WatchedTime {
  Recording recording;
  double tick = 0;
  double tick_rate = 60;              // Hz
  double pace = 1;                    // playback speed: simulated seconds per real second; 0: paused
  std::optional<std::uint64_t> wish;  // requested tick that is not reached yet
  Eigen::Vector2d pointer = Eigen::Vector2d::Zero();  // points from the top left
};

/// Returns the time of a recording's tick as text in minutes and seconds: "1:02.5".
std::string clock_time(double tick, double tick_rate);
/// Returns a text that describes the event of a mark on a recording's time bar.
std::string in_words(const RecordingMark& mark, const Catalogue& words = {});

/// Adds a recording's time bar to the view's lower border. If the pointer is on an event's mark, a
/// description of the event is above the bar.
void add_time_bar(DrawList& list, const WatchedTime& time);

}  // namespace prosector
