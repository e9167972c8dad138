// Phase 1: inputs. Hands appear, move their targets, bend, take hold and let go.

#include <algorithm>

#include "server/physics/simulation_impl.h"

namespace prosector {

std::vector<Hand>::iterator Simulation::Impl::find_hand(ParticipantId participant, std::size_t side) {
  const auto at = std::find_if(hands.begin(), hands.end(), [&](const Hand& hand) {
    return hand.participant == participant && hand.side == side;
  });
  return at;
}

const Hand* Simulation::Impl::hand_at(std::size_t slot) const {
  for (const Hand& hand : hands)
    if (hand.slot == slot) return &hand;
  return nullptr;
}

void Simulation::Impl::take_inputs(const TickInput& input) {
  for (const EffortChange& change : input.efforts)
    if (is_soft(change.body) && soft_index(change.body) < soft.size())
      soft[soft_index(change.body)].steps_down =
          std::clamp(change.steps_down, 0, static_cast<int>(max_steps_down));
  const auto target_of = [&](const HandEvent& event) {
    return std::find_if(input.targets.begin(), input.targets.end(), [&](const HandTarget& t) {
      return t.participant == event.participant && t.hand == event.hand;
    });
  };
  for (Hand& hand : hands) hand.previous_target = hand.target;
  for (const HandEvent& event : input.events) {
    if (event.kind == HandEvent::Kind::reset_body) {
      if (event.body < model.rigid.size() + model.soft.size()) reset_body(event.body);
      continue;
    }
    if (event.hand > right_hand) continue;
    const auto hand = find_hand(event.participant, event.hand);
    if (event.kind == HandEvent::Kind::appear) {
      if (hand != hands.end()) continue;
      appear(event.participant, event.hand);
      const auto made = find_hand(event.participant, event.hand);
      if (const auto t = target_of(event); t != input.targets.end() && is_finite(t->target)) {
        made->target = made->previous_target = t->target;
        RigidMotion motion;
        motion.pose = t->target * model.hands[event.hand].center;
        world.set_motion(made->slot, motion);
      }
    } else if (hand == hands.end()) {
      continue;
    } else if (event.kind == HandEvent::Kind::vanish) {
      vanish(hand);
    } else if (event.kind == HandEvent::Kind::grasp) {
      grasp(*hand);
    } else {
      release(*hand, "opened");
    }
  }
  for (const PartEvent& event : input.parts) report.part_answers.push_back(obey(event));
  for (const HandTarget& t : input.targets) {
    const auto hand = find_hand(t.participant, t.hand);
    if (hand == hands.end() || !is_finite(t.target) || t.target.p.cwiseAbs().maxCoeff() > max_coordinate)
      continue;
    hand->target = {t.target.p, t.target.q.normalized()};
    if (std::all_of(t.flexion.begin(), t.flexion.end(), [](double f) { return std::isfinite(f); }))
      hand->target_flexion = t.flexion;
  }
  if (panels) {
    for (const HeadPlace& head : input.heads) panels->take(head);
    for (const PanelEvent& event : input.panels) panels->take(event, *this);
  }
  bend_fingers();
  for (const Hand& hand : hands)
    if (hand.hold && !is_soft(hand.hold->body)) world.wake(hand.hold->body);
  for (const Drive& d : input.drives) drive(d);
}

void Simulation::Impl::drive(const Drive& drive) {
  const bool known = drive.body < model.rigid.size() && !world.dynamic(drive.body);
  if (known && is_finite(drive.pose) && drive.pose.p.cwiseAbs().maxCoeff() <= max_coordinate) {
    const Pose pose = {drive.pose.p, drive.pose.q.normalized()};
    world.drive(drive.body, pose * model.rigid[drive.body].center, model.h);
    return;
  }
  BodyReport& row = report.bodies.emplace_back();
  row.body = drive.body < model.rigid.size() ? model.rigid[drive.body].name : "none";
  row.note =
      known ? "a drive to nowhere in the room was ignored" : "a drive of what is no fixed body was ignored";
}

void Simulation::Impl::appear(ParticipantId participant, std::size_t side) {
  Hand hand;
  hand.participant = participant;
  hand.side = side;
  RigidMotion motion;
  motion.pose = model.hands[side].center;
  hand.slot = world.add(model.hands[side].setup, motion);
  const auto at = std::find_if(hands.begin(), hands.end(), [&](const Hand& other) {
    return std::pair(participant, side) < std::pair(other.participant, other.side);
  });
  hands.insert(at, hand);
}

void Simulation::Impl::vanish(std::vector<Hand>::iterator hand) {
  release(*hand, "its hand is gone");
  for (std::size_t i = 0; i < soft.size(); ++i) soft[i].quiet_ticks = 0;
  world.remove(hand->slot);
  hands.erase(hand);
}

void Simulation::Impl::grasp(Hand& hand) {
  if (hand.hold) return;
  refresh_colliders();
  hand.hold = reach_rigid(hand);
  if (!hand.hold) hand.hold = reach_soft(hand);
  if (!hand.hold) return;
  if (is_soft(hand.hold->body))
    wake_soft(soft_index(hand.hold->body));
  else
    world.set_collides(hand.slot, hand.hold->body, false);
}

void Simulation::Impl::release(Hand& hand, const std::string& why) {
  if (!hand.hold) return;
  report.let_go.push_back({hand.participant, hand.side, hand.hold->body, why});
  if (!is_soft(hand.hold->body)) world.set_collides(hand.slot, hand.hold->body, true);
  hand.hold.reset();
}

/// A bone that broke is put back whole.
void Simulation::Impl::reset_body(BodyId body) {
  if (!is_soft(body)) {
    while (model.rigid[body].whole) body = static_cast<BodyId>(*model.rigid[body].whole);
    for (BodyId piece = body + 1; piece < model.rigid.size(); ++piece) {
      std::size_t root = piece;
      while (model.rigid[root].whole) root = *model.rigid[root].whole;
      if (root != body) continue;
      let_go_of(piece, "it was put back");
      make(piece, initial_part(piece));
    }
  }
  let_go_of(body, "it was put back");
  make(body, {});
  lost.erase(body);
  put_at_start(body);
}

void Simulation::Impl::put_at_start(BodyId body) {
  if (!is_soft(body)) {
    RigidMotion motion;
    motion.pose = model.rigid[body].start * model.rigid[body].center;
    world.set_motion(body, motion);
    return;
  }
  const std::size_t i = soft_index(body);
  const int steps_down = soft[i].steps_down;  // the server is as busy as it was
  soft[i] = model.soft[i]->initial_state();
  soft[i].steps_down = steps_down;
  soft[i].motion.x = soft[i].motion.x_prev = equilibrium[i];
  memories[i].clear();
  stored[i].reset();
  surfaces[i].update(soft[i].motion.x.data());
}

}  // namespace prosector
