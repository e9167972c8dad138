#pragma once
// Whether a rigid body's state travels this tick. It does so in motion each tick; then a few times that it
// has settled, since each sample may get lost. Then it does once a second while it lies elsewhere than the
// scene says, for those who come late.

#include <cstdint>
#include <vector>

#include "common/messages.h"
#include "server/session/snapshot.h"

namespace prosector {

class RigidSender {
 public:
  RigidSender(BodyId body, const Pose& scene_pose) : body_(body), scene_pose_(scene_pose) {}
  void update(const RigidBodyState& now, SimTime time, bool everything, std::vector<Message>& out);

 private:
  BodyId body_;
  Pose scene_pose_, sent_pose_ = scene_pose_;
  std::uint64_t sent_tick_ = 0;
  std::uint32_t epoch_ = 0;
  int settled_left_ = 0;  // how often "settled" is still to be said
};

}  // namespace prosector
