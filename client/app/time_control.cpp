#include "client/app/time_control.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace prosector {
namespace {

constexpr double short_way = 10, long_way = 60;  // s of the recording
constexpr double arrived = 0.3;                  // s of the recording: so near to a wish it is fulfilled
constexpr double patience = 10;                  // s after which a wish is given up
constexpr double between_asks = 0.15;  // s of a drag: a server takes no more than 50 commands a second

Command set_pace(double pace) {
  Command out;
  out.kind = CommandKind::set_pace;
  out.value = pace;
  return out;
}

}  // namespace

void TimeControl::see(const std::optional<ShownTime>& shown, double now) {
  shown_ = shown;
  now_ = now;
  if (!shown_) drags_ = false;
  if (!wish_ || drags_) return;
  const bool is_there =
      shown_ && std::abs(shown_->tick - static_cast<double>(*wish_)) < arrived * shown_->tick_rate;
  if (is_there || !shown_ || now - wished_at_ > patience) wish_.reset();
}

std::optional<Command> TimeControl::press(Key key) {
  if (!shown_) return std::nullopt;
  const double pace = shown_->pace;
  if (key == Key::left) return go_by(-short_way);
  if (key == Key::right) return go_by(short_way);
  if (key == Key::page_up) return go_by(-long_way);
  if (key == Key::page_down) return go_by(long_way);
  if (key == Key::backspace) return go_to(0);
  if (key == Key::up) return set_pace(pace == 0 ? 1 : std::min(2 * pace, most_pace));
  if (key == Key::down && pace > 0) return set_pace(std::max(pace / 2, least_pace));
  return std::nullopt;
}

std::optional<Command> TimeControl::press(const OverlayFrame& frame, const Eigen::Vector2d& at) {
  if (!shown_) return std::nullopt;
  const TimeBar bar(frame, shown_->last_tick);
  if (!bar.is_on(at)) return std::nullopt;
  drags_ = true;
  return go_to(static_cast<double>(bar.tick_at(at.x())));
}

std::optional<Command> TimeControl::move(const OverlayFrame& frame, const Eigen::Vector2d& at) {
  if (!drags_ || !shown_) return std::nullopt;
  wish_for(static_cast<double>(TimeBar(frame, shown_->last_tick).tick_at(at.x())));
  if (now_ - asked_at_ < between_asks) return std::nullopt;
  return go_to(static_cast<double>(*wish_));
}

std::optional<Command> TimeControl::let_go() {
  if (!std::exchange(drags_, false) || !wish_) return std::nullopt;
  return go_to(static_cast<double>(*wish_));
}

void TimeControl::wish_for(double tick) {
  wish_ = static_cast<std::uint64_t>(std::clamp(tick, 0.0, static_cast<double>(shown_->last_tick)));
  wished_at_ = now_;
}

Command TimeControl::go_to(double tick) {
  wish_for(tick);
  asked_at_ = now_;
  Command out;
  out.kind = CommandKind::seek;
  out.revision = static_cast<std::uint32_t>(*wish_);
  return out;
}

/// Goes on from where one wants to be already.
Command TimeControl::go_by(double seconds) {
  const double from = wish_ ? static_cast<double>(*wish_) : shown_->tick;
  return go_to(from + seconds * shown_->tick_rate);
}

}  // namespace prosector
