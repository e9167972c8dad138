#pragma once
// Rate limit for repeated message lines.

#include <cstddef>
#include <map>
#include <optional>
#include <string>

namespace prosector {

/// Returns the line without its digits, so that lines that differ only in numbers are of the same kind.
std::string line_kind(std::string line);

/// Passes at most one line of each kind per `seconds`. The number of suppressed lines is appended to the next
/// one: "… (and 7 like it)".
class RepeatedLineFilter {
 public:
  static constexpr std::size_t most_kinds = 256;

  explicit RepeatedLineFilter(double seconds) : seconds_(seconds) {}

  /// Returns the line to print now, or nullopt to suppress it. `now` is in seconds on a monotonic clock.
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
