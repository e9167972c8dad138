#pragma once
// A condition that comes and goes, reported without a flood.

#include <array>
#include <limits>
#include <optional>

namespace prosector {

/// Reports when a condition begins and ends, each at most once per `interval` seconds. Where it flickers, the
/// state that it is in by then is reported when the interval is over.
class ReportedState {
 public:
  explicit ReportedState(double interval) : interval_(interval) {}

  /// Takes whether the condition holds now; `now` is in seconds of a clock that never goes back. Returns the
  /// state to report, if any.
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
  std::array<double, 2> last_ = {never, never};  // s: when its end and its begin were reported
};

}  // namespace prosector
