#include "client/app/pose_life.h"

#include <algorithm>

namespace prosector {
namespace {

constexpr std::int64_t least_life_ns = 250'000'000, most_life_ns = 1'000'000'000;
constexpr std::int64_t gaps_of_life = 2;  // after which the next pose is taken to be missing

}  // namespace

void PoseLife::see(std::int64_t time_ns, std::int64_t now_ns) {
  if (time_ns <= seen_ns_) return;  // of another camera, or told twice
  gap_before_ns_ = last_gap_ns_;
  last_gap_ns_ = seen_ns_ == 0 ? 0 : time_ns - seen_ns_;
  seen_ns_ = time_ns;
  delay_ns_ = now_ns - time_ns;
}

/// Returns how long the last pose counts: the next one is expected one gap later, with the same delay. The
/// shorter of the last two gaps is used, because one that is long alone was a loss.
std::int64_t PoseLife::life_ns() const {
  const std::int64_t gap = std::min(last_gap_ns_, gap_before_ns_);
  return std::clamp(delay_ns_ + gaps_of_life * gap, least_life_ns, most_life_ns);
}

}  // namespace prosector
