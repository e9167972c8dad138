#pragma once
// Decides whether to send a rigid body's state this tick. In motion it is sent each tick. After the body has
// settled it is repeated a few times, since samples may get lost. Then it is sent once a second for late
// joiners, while the body's pose is not that of the scene.

#include <cstdint>
#include <vector>

#include "common/ids.h"
#include "common/math.h"
#include "idl/message.h"
#include "server/session/sending/snapshot.h"

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
  int settled_left_ = 0;  // remaining repeats of the settled state
};

}  // namespace prosector
