#pragma once
// A token bucket: passes `rate` samples per second on average, in bursts of at most `burst` samples.

#include <algorithm>
#include <cstdint>

#include "common/assert.h"

namespace prosector {

class TokenBucket {
 public:
  /// Starts with a full bucket. `rate` is the average number of samples per second that it passes, and
  /// `burst` the largest number at a time; both > 0.
  TokenBucket(double rate, double burst) : rate_(rate), burst_(burst), tokens_(burst) {
    PROSECTOR_ASSERT(rate > 0 && burst > 0);
  }

  /// Removes one token at time `now_ns` (monotonic clock), which allows one sample to pass. Returns false if
  /// no token is available.
  bool take(std::int64_t now_ns) {
    tokens_ = tokens_at(now_ns);
    last_ns_ = std::max(last_ns_, now_ns);
    if (tokens_ < 1) return false;
    tokens_ -= 1;
    return true;
  }
  /// Returns whether the bucket has all its tokens at time `now_ns` (monotonic clock), and thus is equivalent
  /// to a new one.
  bool full(std::int64_t now_ns) const { return tokens_at(now_ns) >= burst_; }

 private:
  double tokens_at(std::int64_t now_ns) const {
    if (last_ns_ < 0 || now_ns <= last_ns_) return tokens_;
    return std::min(burst_, tokens_ + rate_ * 1e-9 * static_cast<double>(now_ns - last_ns_));
  }

  double rate_, burst_, tokens_;
  std::int64_t last_ns_ = -1;
};

}  // namespace prosector
