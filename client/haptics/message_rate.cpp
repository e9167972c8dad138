#include "client/haptics/message_rate.h"

#include <algorithm>
#include <cmath>

namespace prosector {
namespace {

constexpr double memory = 0.1;  // weight of the newest interval
constexpr double least_wait = 0.02,
                 most_wait = 0.25;        // s without a message, until the stream counts as interrupted
constexpr double longest_interval = 0.2;  // s: a longer gap is a pause and does not count as an interval

}  // namespace

void MessageRate::note(double time) {
  if (last_ >= 0 && time - last_ < longest_interval) {
    const double off = time - last_ - interval_;
    interval_ += memory * off;
    jitter_ += memory * (std::abs(off) - jitter_);
  }
  last_ = time;
}

bool MessageRate::broken(double time) const {
  return last_ < 0 || time - last_ > std::clamp(3 * (interval_ + jitter_), least_wait, most_wait);
}

}  // namespace prosector
