#include "server/physics/mechanics/coupled/vibration.h"

#include <algorithm>
#include <cmath>

#include "common/assert.h"

namespace prosector::coupled {
namespace {

constexpr double calmed_after = 2, over_after = 2.5;  // s
constexpr double least_share = 0.1;                   // of a cell
constexpr double arm = 0.1;                           // m: distance of the points from the origin of the pose

}  // namespace

void Lingerers::begin_tick(std::uint64_t tick) {
  PROSECTOR_ASSERT(h_ > 0);
  next_.clear();
  may_begin_ = tick % static_cast<std::uint64_t>(std::max(1.0, std::round(1 / h_))) == 0;
}

Lingerers::Map Lingerers::calmed_next() const {
  Map out = watched_;
  std::erase_if(out, [&](const auto& entry) { return (entry.second.ticks + 1) * h_ <= calmed_after; });
  return out;
}

VibrationState Lingerers::linger(const WatchedBody& now) {
  PROSECTOR_ASSERT(now.within >= 0);
  const auto found = watched_.find(now.body);
  if (found == watched_.end()) {
    if (may_begin_) next_[now.body].place = now.place;
    return VibrationState::moving;
  }
  StuckBody& then = found->second;
  if (then.place.size() != now.place.size() ||
      (now.place - then.place).lpNorm<Eigen::Infinity>() > now.within)
    then = {now.place, 0};
  const double seconds = ++then.ticks * h_;
  next_[now.body] = std::move(then);
  if (seconds > over_after) return VibrationState::over;
  return seconds > calmed_after ? VibrationState::calmed : VibrationState::moving;
}

std::optional<double> lingering_bound(const soft::SoftBody& body, bool touches) {
  const bool thin = body.anatomy().thickness > 0;
  if (!touches && !thin) return std::nullopt;
  return (thin && touches ? 1 : least_share) * body.desc().geometry.cell;
}

VecX points_of(const Pose& pose) {
  VecX out(pose_numbers);
  out << pose.p, pose * Vec3(arm, 0, 0), pose * Vec3(0, arm, 0);
  return out;
}

}  // namespace prosector::coupled
