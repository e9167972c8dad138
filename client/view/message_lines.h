#pragma once
// The lines of messages in a picture: what happened a moment ago, in words, for as long as reading takes.

#include <cstddef>
#include <deque>
#include <string>
#include <vector>

namespace prosector {

/// Shows at most two messages at a time. Further ones wait until one was there for as long as reading it
/// takes, or for 1.5 s if that is shorter. More than eight do not wait: the oldest waiting ones are counted
/// instead. Time is in seconds of any clock that never goes back.
class MessageLines {
 public:
  /// Takes a message. One that is shown already is counted there, and stays for longer.
  void say(std::string text, double now);
  /// Returns the lines to draw, the oldest first: "hand: tracked again (3 times)".
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
  std::vector<Line> shown_;
  std::deque<std::string> waiting_;
  std::size_t left_out_ = 0;

  void fill(double now);
};

}  // namespace prosector
