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

/// Whether a message responds to the user's own action, or is news about others and the simulation.
enum class MessageKind : std::uint8_t { own, news };

/// Shows at most two messages at a time. Responses to the user's own actions have the lowest line, which news
/// never displace. Further messages wait until a shown one has stayed for its reading time, or for 1.5 s if
/// that is shorter. At most eight wait: beyond that the oldest waiting messages are counted instead. Times
/// are in seconds of any monotonic clock.
class MessageLines {
 public:
  explicit MessageLines(Catalogue words = {}) : words_(std::move(words)) {}

  /// Adds a message. If the same message is shown already, increments its count and extends its time.
  void say(std::string text, double now, MessageKind kind = MessageKind::news);
  /// Returns the lines to draw: news first, and the oldest first within each kind. Example: "hand: tracked
  /// again (3 times)".
  std::vector<std::string> shown(double now);

  static constexpr std::size_t lines = 2, most_waiting = 8;
  static constexpr double least_stay = 1.5;  // s, of a message while others wait
  /// Returns how long (s) a message stays: the time to read it aloud, within bounds.
  static double reading_time(const std::string& text);

 private:
  struct Line {
    std::string text;
    int times = 1;
    double since = 0, until = 0;  // s
  };
  /// The messages of one kind.
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
