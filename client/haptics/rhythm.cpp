#include "client/haptics/rhythm.h"

#include <algorithm>
#include <cmath>

namespace prosector {
namespace {

constexpr double memory = 0.1;                         // weight of the newest interval
constexpr double least_wait = 0.02, most_wait = 0.25;  // s without a message, until none is expected
constexpr double longest_interval = 0.2;               // s: a longer one is a pause, and tells of no rate

}  // namespace

void Rhythm::note(double time) {
  if (last_ >= 0 && time - last_ < longest_interval) {
    const double off = time - last_ - interval_;
    interval_ += memory * off;
    jitter_ += memory * (std::abs(off) - jitter_);
  }
  last_ = time;
}

bool Rhythm::broken(double time) const {
  return last_ < 0 || time - last_ > std::clamp(3 * (interval_ + jitter_), least_wait, most_wait);
}

}  // namespace prosector
