#include "server/session/sending/rigid_sender.h"

namespace prosector {
namespace {

constexpr int settled_repeats = 5;
constexpr std::uint64_t moving_refresh_ticks = 15, resting_refresh_ticks = 60;
constexpr double min_shift = 1e-5;  // m: smaller movements are not sent
constexpr double min_turn = 1e-4;   // rad: smaller rotations are not sent

bool apart(const Pose& a, const Pose& b) {
  return (a.p - b.p).norm() > min_shift || a.q.angularDistance(b.q) > min_turn;
}

}  // namespace

void RigidSender::update(const RigidBodyState& now, SimTime time, bool everything,
                         std::vector<Message>& out) {
  if (time.epoch != epoch_) settled_left_ = settled_repeats;  // clients dropped the body's state
  epoch_ = time.epoch;
  const bool displaced = apart(now.pose, scene_pose_);
  const bool moved = apart(now.pose, sent_pose_);
  const std::uint64_t age = time.tick - sent_tick_;
  bool send = moved;
  if (now.asleep) {
    send |= settled_left_ > 0 || (displaced && (everything || age >= resting_refresh_ticks));
    if (settled_left_ > 0) --settled_left_;
  } else {
    const bool in_motion = now.linear_velocity.norm() > 1e-3 || now.angular_velocity.norm() > 1e-2;
    send |= in_motion || everything || age >= moving_refresh_ticks;
    settled_left_ = settled_repeats;
  }
  if (!send) return;
  out.push_back(RigidState{body_, time, now.pose, now.linear_velocity, now.angular_velocity, now.asleep});
  sent_pose_ = now.pose;
  sent_tick_ = time.tick;
}

}  // namespace prosector
