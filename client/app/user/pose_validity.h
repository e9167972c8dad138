#pragma once
// Validity time of a tracked pose.

#include <cstdint>

namespace prosector {

/// Timer that decides for how long the last measured pose of a tracked object stays valid. Times are in ns of
/// the monotonic clock.
class PoseValidity {
 public:
  /// Records a measurement of the object's pose that was made at `time_ns` and received at `now_ns`.
  void see(std::int64_t time_ns, std::int64_t now_ns);
  /// Returns whether the last measured pose is too old to use. It is valid until the next one is due, which
  /// is later for slow cameras or slow evaluation; at least 0.25 s and at most 1 s.
  bool is_over(std::int64_t now_ns) const { return now_ns - seen_ns_ > validity_ns(); }
  /// Returns the time of the last measurement of the pose; 0 if there was none.
  std::int64_t seen_ns() const { return seen_ns_; }

 private:
  std::int64_t validity_ns() const;

  std::int64_t seen_ns_ = 0, delay_ns_ = 0, last_gap_ns_ = 0, gap_before_ns_ = 0;
};

}  // namespace prosector
