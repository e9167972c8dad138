#pragma once
// Rate-limited reporting of an on/off condition.

#include <array>
#include <limits>
#include <optional>

namespace prosector {

/// Filter for reports of an on/off condition: it reports when the condition begins and when it ends, each at
/// most once per `interval` seconds. If the condition flickers, its state at the end of the interval is
/// reported.
class RateLimitedFlag {
 public:
  explicit RateLimitedFlag(double interval) : interval_(interval) {}

  /// Updates the on/off condition with its current state `holds` at the time `now` (seconds on a monotonic
  /// clock). Returns the state to report now, or nullopt if there is nothing to report.
  std::optional<bool> look(bool holds, double now) {
    double& last = last_[holds ? 1 : 0];
    if (holds == reported_ || now - last < interval_) return std::nullopt;
    reported_ = holds;
    last = now;
    return holds;
  }

 private:
  static constexpr double never = -std::numeric_limits<double>::infinity();

  double interval_;
  bool reported_ = false;
  std::array<double, 2> last_ = {never, never};  // s: times of the last report of its end and of its start
};

}  // namespace prosector
