#include "client/app/desk/time_control.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace prosector {
namespace {

constexpr double short_way = 10, long_way = 60;  // s of the recording, per key press
constexpr double arrived = 0.3;    // s of the recording: distance at which a request counts as reached
constexpr double time_limit = 10;  // s until an unreached request is discarded
constexpr double between_asks =
    0.15;  // s between two commands of a drag: the server accepts at most 50 commands a second

}  // namespace

void TimeControl::see(const std::optional<ShownTime>& shown, double now) {
  shown_ = shown;
  now_ = now;
  if (!shown_) drags_ = false;
  if (!wish_ || drags_) return;
  const bool is_there =
      shown_ && std::abs(shown_->tick - static_cast<double>(*wish_)) < arrived * shown_->tick_rate;
  if (is_there || !shown_ || now - wished_at_ > time_limit) wish_.reset();
}

std::optional<CommandBody> TimeControl::press(Key key) {
  if (!shown_) return std::nullopt;
  const double pace = shown_->pace;
  if (key == Key::left) return go_by(-short_way);
  if (key == Key::right) return go_by(short_way);
  if (key == Key::page_up) return go_by(-long_way);
  if (key == Key::page_down) return go_by(long_way);
  if (key == Key::backspace) return go_to(0);
  if (key == Key::up) return SetPace{pace == 0 ? 1 : std::min(2 * pace, max_pace)};
  if (key == Key::down && pace > 0) return SetPace{std::max(pace / 2, min_pace)};
  return std::nullopt;
}

std::optional<CommandBody> TimeControl::press(const OverlayFrame& frame, const Eigen::Vector2d& at) {
  if (!shown_) return std::nullopt;
  const TimeBar bar(frame, shown_->last_tick);
  if (!bar.is_on(at)) return std::nullopt;
  drags_ = true;
  return go_to(static_cast<double>(bar.tick_at(at.x())));
}

std::optional<CommandBody> TimeControl::move(const OverlayFrame& frame, const Eigen::Vector2d& at) {
  if (!drags_ || !shown_) return std::nullopt;
  wish_for(static_cast<double>(TimeBar(frame, shown_->last_tick).tick_at(at.x())));
  if (now_ - asked_at_ < between_asks) return std::nullopt;
  return go_to(static_cast<double>(*wish_));
}

std::optional<CommandBody> TimeControl::let_go() {
  if (!std::exchange(drags_, false) || !wish_) return std::nullopt;
  return go_to(static_cast<double>(*wish_));
}

void TimeControl::wish_for(double tick) {
  wish_ = static_cast<std::uint64_t>(std::clamp(tick, 0.0, static_cast<double>(shown_->last_tick)));
  wished_at_ = now_;
}

CommandBody TimeControl::go_to(double tick) {
  wish_for(tick);
  asked_at_ = now_;
  return Seek{static_cast<std::uint32_t>(*wish_)};
}

/// Seeks relative to the pending request, or to the displayed time if there is none.
CommandBody TimeControl::go_by(double seconds) {
  const double from = wish_ ? static_cast<double>(*wish_) : shown_->tick;
  return go_to(from + seconds * shown_->tick_rate);
}

}  // namespace prosector
