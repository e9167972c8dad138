#pragma once
// Lines for people that would repeat each other.

#include <cstddef>
#include <map>
#include <optional>
#include <string>

namespace prosector {

/// Returns a line without its figures, which change while it says the same.
std::string line_kind(std::string line);

/// Lets through one line of each kind per `seconds`, and counts the others on the next: "… (and 7 like it)".
class RepeatedLines {
 public:
  static constexpr std::size_t most_kinds = 256;

  explicit RepeatedLines(double seconds) : seconds_(seconds) {}

  /// Returns the line to print now, if any. `now` is in seconds of a clock that never goes back.
  std::optional<std::string> admit(const std::string& line, double now);

 private:
  struct Kind {
    double printed = 0;  // s
    std::size_t left_out = 0;
  };
  double seconds_;
  std::map<std::string, Kind> kinds_;
};

}  // namespace prosector
