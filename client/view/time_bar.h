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

/// Height in points that is reserved for the bar at the lower border.
inline constexpr double time_bar_strip = 30;

/// Layout of the bar in a view.
class TimeBar {
 public:
  /// Takes the recording's length in ticks.
  TimeBar(const OverlayFrame& frame, std::uint64_t last_tick);

  double left() const { return left_; }
  double right() const { return right_; }
  double middle() const { return middle_; }  // of its height, points from the top
  /// Returns the position of a tick, points from the left.
  double place_of(double tick) const;
  /// Returns the tick at `x`, points from the left, clamped to the recording.
  std::uint64_t tick_at(double x) const;
  /// Returns whether a position, points from the top left, is on the bar.
  bool is_on(const Eigen::Vector2d& at) const;

 private:
  double left_, right_, middle_;  // points
  double last_tick_;
};

/// State of the playback that the bar shows.
struct WatchedTime {
  Recording recording;
  double tick = 0;
  double tick_rate = 60;              // Hz
  double pace = 1;                    // playback speed: simulated seconds per real second; 0: paused
  std::optional<std::uint64_t> wish;  // requested tick that is not reached yet
  Eigen::Vector2d pointer = Eigen::Vector2d::Zero();  // points from the top left
};

/// Returns a time of a recording as text: "1:02.5".
std::string clock_time(double tick, double tick_rate);
/// Returns the description of a mark's event.
std::string in_words(const RecordingMark& mark, const Catalogue& words = {});

/// Adds the bar, with a description above it of the mark at the pointer.
void add_time_bar(DrawList& list, const WatchedTime& time);

}  // namespace prosector
