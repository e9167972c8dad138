#include "client/view/message_lines.h"

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

void MessageLines::say(std::string text, double now, MessageKind kind) {
  if (text.empty()) return;
  fill(now);
  (kind == MessageKind::own ? own_ : news_).say(std::move(text), now);
  fill(now);
}

std::vector<std::string> MessageLines::shown(double now) {
  fill(now);
  std::vector<std::string> out;
  for (const Lane* lane : {&news_, &own_})
    for (const Line& line : lane->shown)
      out.push_back(line.times > 1 ? words_.tr("{} ({} times)", line.text, line.times) : line.text);
  return out;
}

void MessageLines::fill(double now) {
  own_.fill(now, 1, words_);
  news_.fill(now, lines - own_.shown.size(), words_);
}

void MessageLines::Lane::say(std::string text, double now) {
  const auto again = std::ranges::find(shown, text, &Line::text);
  if (again != shown.end()) {
    ++again->times;
    again->until = now + reading_time(text);
    return;
  }
  if (std::ranges::find(waiting, text) != waiting.end()) return;
  waiting.push_back(std::move(text));
  if (waiting.size() > most_waiting) {
    waiting.pop_front();
    ++left_out;
  }
}

/// Removes messages past their time and shows waiting ones. If the room has shrunk, the oldest line waits
/// again unless it was shown long enough.
void MessageLines::Lane::fill(double now, std::size_t room, const Catalogue& words) {
  std::erase_if(shown, [&](const Line& line) { return line.until <= now; });
  for (; shown.size() > room; shown.erase(shown.begin()))
    if (shown.front().since + least_stay > now) waiting.push_front(shown.front().text);
  while (!waiting.empty()) {
    if (shown.size() == room && shown.front().since + least_stay > now) return;
    if (shown.size() == room) shown.erase(shown.begin());
    std::string text = std::move(waiting.front());
    waiting.pop_front();
    if (left_out > 0) text = words.tr("{} (and {} earlier)", text, std::exchange(left_out, 0));
    shown.push_back({text, 1, now, now + reading_time(text)});
  }
}

}  // namespace prosector
