#pragma once
// Writes the events of a live session, such as joins, to its log.

#include <functional>
#include <string>
#include <vector>

#include "common/repeated_line_filter.h"
#include "server/session/people/session.h"

namespace prosector {

class EventLog {
 public:
  /// Stores `say`, which is called with the lines of the log.
  explicit EventLog(std::function<void(const std::string&)> say);

  /// Writes a line for each event. Lines of a kind that may flood the log are limited to one per interval.
  /// `now` is in seconds on a monotonic clock.
  void write(const std::vector<SessionEvent>& events, double now);

 private:
  std::function<void(const std::string&)> say_;
  RepeatedLineFilter repeated_;
};

}  // namespace prosector
