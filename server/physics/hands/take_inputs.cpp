#include "server/physics/hands/take_inputs.h"

#include <algorithm>
#include <cmath>

#include "server/physics/hands/fingers.h"
#include "server/physics/hands/grasping.h"
#include "server/physics/hands/hands.h"
#include "server/physics/panel/panel_station.h"
#include "server/physics/parts/part_rules.h"

namespace prosector {
namespace {

/// Takes a fixed body on to where a program wants it when the tick ends.
void drive(Bodies& bodies, const Drive& drive, StepReport& report) {
  const bool known = drive.body < bodies.model.rigid.size() && !bodies.rigid.dynamic(drive.body);
  if (known && is_finite(drive.pose) && drive.pose.p.cwiseAbs().maxCoeff() <= max_coordinate) {
    const Pose pose = {drive.pose.p, drive.pose.q.normalized()};
    bodies.rigid.drive(drive.body, pose * bodies.model.rigid[drive.body].center, bodies.model.h);
    return;
  }
  BodyReport& row = report.bodies.emplace_back();
  row.body = drive.body < bodies.model.rigid.size() ? bodies.model.rigid[drive.body].name : "none";
  row.note =
      known ? "a drive to nowhere in the room was ignored" : "a drive of what is no fixed body was ignored";
}

}  // namespace

void take_inputs(State& state, Colliders& colliders, const TickInput& input, StepReport& report) {
  Bodies& bodies = state.bodies;
  for (const EffortChange& change : input.efforts)
    if (bodies.is_soft(change.body) && bodies.soft_index(change.body) < bodies.soft.size())
      bodies.soft[bodies.soft_index(change.body)].state.steps_down =
          std::clamp(change.steps_down, 0, static_cast<int>(max_steps_down));
  const auto target_of = [&](const HandEvent& event) {
    return std::find_if(input.targets.begin(), input.targets.end(), [&](const HandTarget& t) {
      return t.participant == event.participant && t.hand == event.hand;
    });
  };
  for (Hand& hand : state.hands) hand.previous_target = hand.target;
  for (const HandEvent& event : input.events) {
    if (event.kind == HandEvent::Kind::reset_body) {
      if (event.body < bodies.model.rigid.size() + bodies.soft.size()) reset_body(state, event.body, report);
      continue;
    }
    if (event.hand > right_hand) continue;
    const auto hand = find_hand(state.hands, event.participant, event.hand);
    if (event.kind == HandEvent::Kind::appear) {
      if (hand != state.hands.end()) continue;
      appear(state, event.participant, event.hand);
      const auto made = find_hand(state.hands, event.participant, event.hand);
      if (const auto t = target_of(event); t != input.targets.end() && is_finite(t->target)) {
        made->target = made->previous_target = t->target;
        RigidMotion motion;
        motion.pose = t->target * bodies.model.hands[event.hand].center;
        bodies.rigid.set_motion(made->slot, motion);
      }
    } else if (hand == state.hands.end()) {
      continue;
    } else if (event.kind == HandEvent::Kind::vanish) {
      vanish(state, hand, report);
    } else if (event.kind == HandEvent::Kind::grasp) {
      grasp(state, colliders, *hand);
    } else {
      release(bodies, *hand, "opened", report);
    }
  }
  for (const PartEvent& event : input.parts) report.part_answers.push_back(obey(state, event, report));
  for (const HandTarget& t : input.targets) {
    const auto hand = find_hand(state.hands, t.participant, t.hand);
    if (hand == state.hands.end() || !is_finite(t.target) ||
        t.target.p.cwiseAbs().maxCoeff() > max_coordinate)
      continue;
    hand->target = {t.target.p, t.target.q.normalized()};
    if (std::all_of(t.flexion.begin(), t.flexion.end(), [](double f) { return std::isfinite(f); }))
      hand->target_flexion = t.flexion;
  }
  if (state.panels) {
    for (const HeadPlace& head : input.heads) state.panels->take(head);
    for (const PanelEvent& event : input.panels) state.panels->take(event, PanelStation(state));
  }
  bend_fingers(state, colliders);
  for (const Hand& hand : state.hands)
    if (hand.hold && !bodies.is_soft(hand.hold->body)) bodies.rigid.wake(hand.hold->body);
  for (const Drive& d : input.drives) drive(bodies, d, report);
}

}  // namespace prosector
