#include "client/app/pose_life.h"

#include <algorithm>

namespace prosector {
namespace {

constexpr std::int64_t least_life_ns = 250'000'000, most_life_ns = 1'000'000'000;
constexpr double gaps_of_life = 2.5;  // the way through networks takes as long as a picture, or nearly

}  // namespace

void PoseLife::see(std::int64_t time_ns) {
  if (time_ns <= seen_ns_) return;  // of another camera, or told twice
  gap_before_ns_ = last_gap_ns_;
  last_gap_ns_ = seen_ns_ == 0 ? 0 : time_ns - seen_ns_;
  seen_ns_ = time_ns;
}

/// Goes by the shorter of the last two gaps: one that was long alone was a loss.
std::int64_t PoseLife::life_ns() const {
  const double gap = static_cast<double>(std::min(last_gap_ns_, gap_before_ns_));
  return std::clamp(static_cast<std::int64_t>(gaps_of_life * gap), least_life_ns, most_life_ns);
}

}  // namespace prosector
