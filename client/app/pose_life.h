#pragma once
// How long a tracked pose counts after it was seen.

#include <cstdint>

namespace prosector {

/// When one thing was seen, and how often it is. Times are of the monotonic clock, ns.
class PoseLife {
 public:
  /// Notes that the thing was seen at `time_ns`, and that this became known at `now_ns`.
  void see(std::int64_t time_ns, std::int64_t now_ns);
  /// Tells whether its last pose is too old to count. It counts until the next one can have arrived, which
  /// takes longer where images come slowly or take long to be evaluated. After 1 s none counts.
  bool is_over(std::int64_t now_ns) const { return now_ns - seen_ns_ > life_ns(); }
  /// Returns when it was seen last; 0: never.
  std::int64_t seen_ns() const { return seen_ns_; }

 private:
  std::int64_t life_ns() const;

  std::int64_t seen_ns_ = 0, delay_ns_ = 0, last_gap_ns_ = 0, gap_before_ns_ = 0;
};

}  // namespace prosector
