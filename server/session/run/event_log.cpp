#include "server/session/run/event_log.h"

#include <optional>
#include <utility>

#include "server/session/run/session_lines.h"

namespace prosector {
namespace {

constexpr double line_interval = 10;  // s between two lines of one kind

bool may_flood(SessionEvent::Kind kind) {
  using Kind = SessionEvent::Kind;
  return kind == Kind::hand_timeout || kind == Kind::hand_stalled || kind == Kind::let_go ||
         kind == Kind::refused;
}

}  // namespace

EventLog::EventLog(std::function<void(const std::string&)> say)
    : say_(std::move(say)), repeated_(line_interval) {}

void EventLog::write(const std::vector<SessionEvent>& events, double now) {
  for (const SessionEvent& e : events) {
    const std::string line = line_of(e);
    if (const auto printed = may_flood(e.kind) ? repeated_.admit(line, now) : line) say_(*printed);
  }
}

}  // namespace prosector
