#include "client/view/message_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace prosector {
namespace {

constexpr double shortest_stay = 4, longest_stay = 12;  // s
constexpr double letters_per_second = 15;

}  // namespace

double MessageLines::reading_time(const std::string& text) {
  return std::clamp(static_cast<double>(text.size()) / letters_per_second, shortest_stay, longest_stay);
}

void MessageLines::say(std::string text, double now) {
  if (text.empty()) return;
  fill(now);
  const auto again = std::ranges::find(shown_, text, &Line::text);
  if (again != shown_.end()) {
    ++again->times;
    again->until = now + reading_time(text);
    return;
  }
  if (std::ranges::find(waiting_, text) != waiting_.end()) return;
  waiting_.push_back(std::move(text));
  if (waiting_.size() > most_waiting) {
    waiting_.pop_front();
    ++left_out_;
  }
  fill(now);
}

std::vector<std::string> MessageLines::shown(double now) {
  fill(now);
  std::vector<std::string> out;
  for (const Line& line : shown_)
    out.push_back(line.times > 1 ? fmt::format("{} ({} times)", line.text, line.times) : line.text);
  return out;
}

/// Takes away what has been read, and puts what waits in its place.
void MessageLines::fill(double now) {
  std::erase_if(shown_, [&](const Line& line) { return line.until <= now; });
  while (!waiting_.empty()) {
    if (shown_.size() == lines && shown_.front().since + least_stay > now) return;
    if (shown_.size() == lines) shown_.erase(shown_.begin());
    std::string text = std::move(waiting_.front());
    waiting_.pop_front();
    if (left_out_ > 0) text = fmt::format("{} (and {} before it)", text, std::exchange(left_out_, 0));
    shown_.push_back({text, 1, now, now + reading_time(text)});
  }
}

}  // namespace prosector
