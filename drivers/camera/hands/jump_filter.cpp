#include "drivers/camera/hands/jump_filter.h"

#include <algorithm>

namespace prosector {
namespace {

constexpr double fastest_turn = 25, fastest_move = 5;  // rad/s, m/s: faster motion of a hand is implausible
constexpr double most_turn = 1.5, most_move = 0.5;     // rad, m: between two images, whatever their times
constexpr double least_seconds =
    0.02;                 // s, least time assumed between poses, because fits of one instant differ, too
constexpr int proof = 2;  // images after the first that must confirm a jump

}  // namespace

bool JumpFilter::leaps(const Seen& from, const Seen& to) {
  const double seconds = std::max(1e-9 * static_cast<double>(to.time_ns - from.time_ns), least_seconds);
  return from.palm.q.angularDistance(to.palm.q) > std::min(fastest_turn * seconds, most_turn) ||
         (from.palm.p - to.palm.p).norm() > std::min(fastest_move * seconds, most_move);
}

bool JumpFilter::accepts_pose(const Pose& palm, std::int64_t time_ns) {
  const Seen now{palm, time_ns};
  if (believed_ && leaps(*believed_, now)) {
    seen_again_ = leapt_ && !leaps(*leapt_, now) ? seen_again_ + 1 : 0;
    leapt_ = now;
    if (seen_again_ < proof) return false;
  }
  leapt_.reset();
  believed_ = now;
  return true;
}

}  // namespace prosector
