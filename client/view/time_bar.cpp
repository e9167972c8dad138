#include "client/view/time_bar.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace prosector {
namespace {

// Points.
// Left: right of the axes; right: room for the time as text.
constexpr double left_margin = 118, right_margin = 178;
constexpr double above_border = 13;
constexpr double thickness = 8, mark_width = 2, mark_height = 16, knob_width = 4, time_knob_height = 20;
constexpr double reach = 9;       // of the pointer above and below the bar's centre line
constexpr double mark_reach = 4;  // horizontal distance of the pointer to a mark
constexpr double text_height = 13, text_above = 34, beside = 10;
const Vec3 rail{0.10, 0.12, 0.14}, done{0.20, 0.62, 0.86}, knob{0.92, 0.94, 0.96}, wished{0.95, 0.75, 0.20};

const Vec3& color_of(MarkKind kind) {
  static const std::array<Vec3, 5> colors = {
      {{0.35, 0.75, 0.45}, {0.45, 0.47, 0.50}, {0.90, 0.20, 0.15}, {0.85, 0.55, 0.90}, {0.95, 0.75, 0.20}}};
  return colors[static_cast<std::size_t>(kind)];
}

/// Returns the mark nearest to the pointer, within reach; null: none.
const RecordingMark* mark_at(const TimeBar& bar, const WatchedTime& time) {
  const RecordingMark* nearest = nullptr;
  double least = mark_reach;
  for (const RecordingMark& mark : time.recording.marks) {
    const double distance = std::abs(bar.place_of(static_cast<double>(mark.tick)) - time.pointer.x());
    if (distance <= least) least = distance, nearest = &mark;
  }
  return nearest;
}

std::string figures(const WatchedTime& time, const Catalogue& words) {
  std::string out = fmt::format("{} / {}", clock_time(time.tick, time.tick_rate),
                                clock_time(static_cast<double>(time.recording.last_tick), time.tick_rate));
  if (time.pace == 0)
    out += fmt::format("  {}", words.tr("stopped"));
  else if (time.pace != 1)
    out += fmt::format("  {:.3g}×", time.pace);
  return out;
}

void add_pointed(DrawList& list, const TimeBar& bar, const WatchedTime& time) {
  if (!bar.is_on(time.pointer)) return;
  const RecordingMark* mark = mark_at(bar, time);
  const auto tick = static_cast<double>(mark != nullptr ? mark->tick : bar.tick_at(time.pointer.x()));
  std::string text = clock_time(tick, time.tick_rate);
  if (mark != nullptr) text += "  " + in_words(*mark, list.words);
  list.texts.push_back({.text = std::move(text),
                        .at = {time.pointer.x() + beside, bar.middle() - text_above, 0},
                        .height = text_height});
}

}  // namespace

TimeBar::TimeBar(const OverlayFrame& frame, std::uint64_t last_tick)
    : left_(left_margin),
      right_(std::max(left_margin + 1, frame.width - right_margin)),
      middle_(frame.height - above_border),
      last_tick_(static_cast<double>(std::max<std::uint64_t>(last_tick, 1))) {}

double TimeBar::place_of(double tick) const {
  return left_ + std::clamp(tick / last_tick_, 0.0, 1.0) * (right_ - left_);
}

std::uint64_t TimeBar::tick_at(double x) const {
  const double share = std::clamp((x - left_) / (right_ - left_), 0.0, 1.0);
  return static_cast<std::uint64_t>(std::lround(share * last_tick_));
}

bool TimeBar::is_on(const Eigen::Vector2d& at) const {
  return at.x() >= left_ - reach && at.x() <= right_ + reach && std::abs(at.y() - middle_) <= reach;
}

std::string clock_time(double tick, double tick_rate) {
  const auto tenths = static_cast<long>(std::floor(10 * tick / tick_rate + 1e-6));
  const long minutes = tenths / 600, hours = minutes / 60;
  const double seconds = static_cast<double>(tenths % 600) / 10;
  if (hours > 0) return fmt::format("{}:{:02}:{:04.1f}", hours, minutes % 60, seconds);
  return fmt::format("{}:{:04.1f}", minutes, seconds);
}

std::string in_words(const RecordingMark& mark, const Catalogue& words) {
  const std::string who = mark.who.empty() ? words.tr("someone") : mark.who;
  switch (mark.kind) {
    case MarkKind::joined:
      return words.tr("{} joined", who);
    case MarkKind::left:
      return words.tr("{} left", who);
    case MarkKind::cut:
      return words.tr("{} cut", who);
    case MarkKind::taken_back:
      return words.tr("{} undid a cut", who);
    case MarkKind::reset:
      return words.tr("{} reset something", who);
  }
  return who;
}

void add_time_bar(DrawList& list, const WatchedTime& time) {
  const OverlayFrame frame(list);
  const TimeBar bar(frame, time.recording.last_tick);
  const double y = bar.middle();
  const auto along = [&](double from, double to, const Vec3& color) {
    list.lines.push_back({frame.at(from, y), frame.at(to, y), color, thickness, true});
  };
  const auto across = [&](double x, double height, const Vec3& color, double width) {
    list.lines.push_back({frame.at(x, y - height / 2), frame.at(x, y + height / 2), color, width, true});
  };
  along(bar.left(), bar.right(), rail);
  along(bar.left(), bar.place_of(time.tick), done);
  for (const RecordingMark& mark : time.recording.marks)
    across(bar.place_of(static_cast<double>(mark.tick)), mark_height, color_of(mark.kind), mark_width);
  if (time.wish) across(bar.place_of(static_cast<double>(*time.wish)), time_knob_height, wished, mark_width);
  across(bar.place_of(time.tick), time_knob_height, knob, knob_width);
  list.texts.push_back({.text = figures(time, list.words),
                        .at = {bar.right() + beside, y - 0.6 * text_height, 0},
                        .height = text_height});
  add_pointed(list, bar, time);
}

}  // namespace prosector
