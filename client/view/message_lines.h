#pragma once
// Message lines in a view: recent events as text, shown as long as reading them takes.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <utility>
#include <vector>

#include "client/language/catalogue.h"

namespace prosector {

/// Kind of a message to the user: a response to the user's own action, or news about others and the
/// simulation.
enum class MessageKind : std::uint8_t { own, news };

/// Queue of messages to the user, of which at most two are shown simultaneously. Responses to the user's own
/// actions have the lowest line, which news never displace. Further messages wait until a shown one has
/// stayed for its reading time, or for 1.5 s if that is shorter. At most eight wait; beyond that the oldest
/// waiting messages are replaced by their number. Times are in seconds of any monotonic clock.
class MessageLines {
 public:
  explicit MessageLines(Catalogue words = {}) : words_(std::move(words)) {}

  /// Adds a message at the time `now`, s. If the same message is shown already, increments its count and
  /// extends its time instead.
  void say(std::string text, double now, MessageKind kind = MessageKind::news);
  /// Returns the lines of messages to draw at the time `now`, s: news first, and the oldest first within each
  /// kind. Example: "hand: tracked again (3 times)".
  std::vector<std::string> shown(double now);

  static constexpr std::size_t lines = 2, most_waiting = 8;
  static constexpr double least_stay = 1.5;  // s, of a message while others wait
  /// Returns for how long (s) a message is shown: the time to read it aloud, within bounds.
  static double reading_time(const std::string& text);

 private:
  struct Line {
    std::string text;
    int times = 1;
    double since = 0, until = 0;  // s
  };
  /// Shown and waiting messages of one kind: responses to the user's own actions, or news.
  struct Lane {
    std::vector<Line> shown;
    std::deque<std::string> waiting;
    std::size_t left_out = 0;

    void say(std::string text, double now);
    void fill(double now, std::size_t room, const Catalogue& words);
  };
  Lane own_, news_;
  Catalogue words_;

  void fill(double now);
};

}  // namespace prosector
