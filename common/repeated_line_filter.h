#pragma once
// Rate limit for repeated message lines.

#include <cstddef>
#include <map>
#include <optional>
#include <string>

namespace prosector {

/// Returns the line without its digits. Lines for which the result is equal differ only in numbers and count
/// as repetitions of each other.
std::string line_kind(std::string line);

/// Filter that passes at most one of several message lines that differ only in numbers per `seconds`. The
/// number of suppressed lines is appended to the next one, as in "… (and 7 similar)".
class RepeatedLineFilter {
 public:
  static constexpr std::size_t most_kinds = 256;

  explicit RepeatedLineFilter(double seconds) : seconds_(seconds) {}

  /// Returns the text to print now for a message line, or nullopt to suppress the line. `now` is in seconds
  /// on a monotonic clock.
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
