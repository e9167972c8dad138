#include "server/physics/stations/hands/hands.h"

#include <algorithm>
#include <utility>

namespace prosector {

std::vector<hands::Hand>::iterator find_hand(std::vector<hands::Hand>& hands, ParticipantId participant,
                                             std::size_t side) {
  return std::find_if(hands.begin(), hands.end(), [&](const hands::Hand& hand) {
    return hand.participant == participant && hand.side == side;
  });
}

void appear(State& state, ParticipantId participant, std::size_t side) {
  Bodies& bodies = state.bodies;
  hands::Hand hand;
  hand.participant = participant;
  hand.side = side;
  rigid::RigidMotion motion;
  motion.pose = bodies.model.hands[side].center;
  hand.slot = bodies.rigid.add(bodies.model.hands[side].setup, motion);
  const auto at = std::find_if(state.hands.begin(), state.hands.end(), [&](const hands::Hand& other) {
    return std::pair(participant, side) < std::pair(other.participant, other.side);
  });
  state.hands.insert(at, hand);
}

void vanish(State& state, std::vector<hands::Hand>::iterator hand, StepReport& report) {
  Bodies& bodies = state.bodies;
  release(bodies, *hand, "its hand is gone", report);
  for (Tissue& tissue : bodies.soft) tissue.state.quiet_ticks = 0;
  bodies.rigid.remove(hand->slot);
  state.hands.erase(hand);
}

void release(Bodies& bodies, hands::Hand& hand, const std::string& why, StepReport& report) {
  if (!hand.hold) return;
  report.let_go.push_back({hand.participant, hand.side, hand.hold->body, why});
  if (!bodies.is_soft(hand.hold->body)) bodies.rigid.set_collides(hand.slot, hand.hold->body, true);
  hand.hold.reset();
}

void let_go_of(State& state, BodyId body, const char* why, StepReport& report) {
  for (hands::Hand& hand : state.hands)
    if (hand.hold && hand.hold->body == body) release(state.bodies, hand, why, report);
}

std::size_t add_hand(const Model& model, rigid::RigidWorld& world, const hands::Hand& hand,
                     const rigid::RigidMotion& motion) {
  const hands::HandModel& shape = model.hands[hand.side];
  const std::size_t slot = world.add(shape.setup, motion);
  const auto poses = hands::hand_part_poses(hand.side, hand.flexion, shape.center);
  for (std::size_t part = 0; part < poses.size(); ++part) world.set_part_pose(slot, part, poses[part]);
  return slot;
}

}  // namespace prosector
