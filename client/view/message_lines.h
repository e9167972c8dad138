#pragma once
// The lines of messages in a picture: what happened a moment ago, in words, for as long as reading takes.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <utility>
#include <vector>

#include "client/language/catalogue.h"

namespace prosector {

/// Whether a message answers what the user did, or is news of others and of the simulation.
enum class MessageKind : std::uint8_t { own, news };

/// Shows at most two messages at a time. What answers the user's own deeds has a line of its own, the lowest,
/// which no news push out. Further messages wait until one was there for as long as reading it takes, or for
/// 1.5 s if that is shorter. More than eight do not wait: the oldest waiting ones are counted instead. Time
/// is in seconds of any clock that never goes back.
class MessageLines {
 public:
  explicit MessageLines(Catalogue words = {}) : words_(std::move(words)) {}

  /// Takes a message. One that is shown already is counted there, and stays for longer.
  void say(std::string text, double now, MessageKind kind = MessageKind::news);
  /// Returns the lines to draw, news first, of each kind the oldest first: "hand: tracked again (3 times)".
  std::vector<std::string> shown(double now);

  static constexpr std::size_t lines = 2, most_waiting = 8;
  static constexpr double least_stay = 1.5;  // s, of a message that others wait for
  /// Returns how long (s) a message stays, by its length: as reading aloud would take, within bounds.
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
