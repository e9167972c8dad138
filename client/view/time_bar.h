#pragma once
// The bar at the lower border of a picture while a recording is watched: how long it is, what time of it is
// shown, and what happened when. Laid out in points (OverlayFrame).

#include <cstdint>
#include <optional>
#include <string>

#include "client/language/catalogue.h"
#include "client/view/draw_list.h"
#include "client/view/overlay_frame.h"

namespace prosector {

/// Points at the lower border that the bar has for itself.
inline constexpr double time_bar_strip = 30;

/// Where the bar lies in a picture.
class TimeBar {
 public:
  /// Takes how long the recording is, in ticks.
  TimeBar(const OverlayFrame& frame, std::uint64_t last_tick);

  double left() const { return left_; }
  double right() const { return right_; }
  double middle() const { return middle_; }  // of its height, points from the top
  /// Returns where a tick is, points from the left.
  double place_of(double tick) const;
  /// Returns the tick that is at `x`, points from the left; beyond an end, the end.
  std::uint64_t tick_at(double x) const;
  /// Tells whether a place, points from the top left, is on the bar.
  bool is_on(const Eigen::Vector2d& at) const;

 private:
  double left_, right_, middle_;  // points
  double last_tick_;
};

/// What the bar shows.
struct WatchedTime {
  Recording recording;
  double tick = 0;
  double tick_rate = 60;                              // Hz
  double pace = 1;                                    // simulated seconds a real one; 0: it stands
  std::optional<std::uint64_t> wish;                  // tick that somebody asked for and is not there yet
  Eigen::Vector2d pointer = Eigen::Vector2d::Zero();  // points from the top left
};

/// Returns a time of a recording for people: "1:02.5".
std::string clock_time(double tick, double tick_rate);
/// Returns what happened at a mark, in words.
std::string in_words(const RecordingMark& mark, const Catalogue& words = {});

/// Adds the bar. What is at the pointer is told above it.
void add_time_bar(DrawList& list, const WatchedTime& time);

}  // namespace prosector
