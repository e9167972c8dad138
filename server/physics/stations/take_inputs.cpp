#include "server/physics/stations/take_inputs.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "common/commands.h"
#include "server/physics/mechanics/organs/locate.h"
#include "server/physics/stations/hands/fingers.h"
#include "server/physics/stations/hands/grasping.h"
#include "server/physics/stations/hands/hands.h"
#include "server/physics/stations/panels/panel_station.h"
#include "server/physics/stations/parts/part_rules.h"

namespace prosector {
namespace {

constexpr double step_back = 0.01;  // m: distance of the tested positions of an appearing hand
constexpr int most_steps_back = 20;

/// Sets a fixed body's target pose at the tick's end.
void drive(Bodies& bodies, const KinematicTarget& drive, StepReport& report) {
  const bool known = drive.body < bodies.model.rigid.size() && !bodies.rigid.dynamic(drive.body);
  if (known && is_finite(drive.pose) && drive.pose.p.cwiseAbs().maxCoeff() <= max_coordinate) {
    const Pose pose = {drive.pose.p, drive.pose.q.normalized()};
    bodies.rigid.drive(drive.body, pose * bodies.model.rigid[drive.body].center, bodies.model.h);
    return;
  }
  BodyReport& row = report.bodies.emplace_back();
  row.body = drive.body < bodies.model.rigid.size() ? bodies.model.rigid[drive.body].name : "none";
  row.note = known ? "a target pose for this body was ignored: it is not finite or outside the room"
                   : "a target pose was ignored: the body does not exist or is not fixed; only fixed bodies "
                     "can be driven";
}

void take(const EffortChange& change, Bodies& bodies) {
  if (bodies.is_soft(change.body) && bodies.soft_index(change.body) < bodies.soft.size())
    bodies.soft[bodies.soft_index(change.body)].state.steps_down =
        std::clamp(change.steps_down, 0, static_cast<int>(max_steps_down));
}

/// Returns whether a hand with its centre at this pose has a sample point in touchable tissue. Skips tissue
/// whose bounding box is elsewhere.
bool in_tissue(const Bodies& bodies, const hands::Hand& hand, const Pose& centre) {
  const std::vector<hands::Feeler> points = hands::feelers(hand, bodies.model.hands[hand.side], centre);
  collision::Aabb around;
  for (const hands::Feeler& f : points) around.add(f.point);
  for (const Tissue& tissue : bodies.soft) {
    if (bodies.parts[bodies.soft_id(tissue.index)].out_of_touch() || !tissue.outer_box().overlaps(around))
      continue;
    const organs::Locator locator(tissue.solver->linear_tets(), tissue.state.motion.x, around);
    if (std::any_of(points.begin(), points.end(),
                    [&](const hands::Feeler& f) { return locator.at(f.point); }))
      return true;
  }
  return false;
}

/// Returns the initial pose of the centre of an appearing hand: at its target, or moved back along its
/// fingers until it is out of tissue. From there the virtual coupling pulls it to the target, and tissue
/// stops it.
Pose out_of_tissue(const Bodies& bodies, const hands::Hand& hand, const Pose& wrist) {
  const Pose& centre = bodies.model.hands[hand.side].center;
  Pose at = wrist;
  for (int step = 0; step <= most_steps_back; ++step, at.p += wrist.q * Vec3(0, 0, step_back))
    if (!in_tissue(bodies, hand, at * centre)) return at * centre;
  return wrist * centre;
}

/// Moves a hand that has just appeared to its target, if this tick has one.
void put_at_target(hands::Hand& hand, std::span<const HandTarget> targets, Bodies& bodies) {
  const auto t = std::find_if(targets.begin(), targets.end(), [&](const HandTarget& target) {
    return target.participant == hand.participant && target.hand == hand.side;
  });
  if (t == targets.end() || !is_finite(t->target)) return;
  hand.target = hand.previous_target = t->target;
  rigid::RigidMotion motion;
  motion.pose =
      t->reaction ? out_of_tissue(bodies, hand, t->target) : t->target * bodies.model.hands[hand.side].center;
  bodies.rigid.set_motion(hand.slot, motion);
}

void take(const HandEvent& event, std::span<const HandTarget> targets, State& state, Colliders& colliders,
          StepReport& report) {
  using Kind = HandEvent::Kind;
  if (event.kind == Kind::reset_body) {
    if (event.body < state.bodies.count()) reset_body(state, event.body, report);
    return;
  }
  if (event.hand > right_hand) return;
  const auto hand = find_hand(state.hands, event.participant, event.hand);
  const bool present = hand != state.hands.end();
  if (event.kind == Kind::appear && !present) {
    appear(state, event.participant, event.hand);
    put_at_target(*find_hand(state.hands, event.participant, event.hand), targets, state.bodies);
  }
  if (event.kind == Kind::appear || !present) return;
  if (event.kind == Kind::vanish)
    vanish(state, hand, report);
  else if (event.kind == Kind::grasp)
    grasp(state, colliders, *hand);
  else if (event.kind == Kind::grasp_body)
    grasp(state, colliders, *hand, event.body);
  else if (event.kind == Kind::regrasp)
    grasp_only(state, colliders, *hand, event.body);
  else
    release(state.bodies, *hand, "opened", report);
}

void take(const HandTarget& t, std::vector<hands::Hand>& hands) {
  const auto hand = find_hand(hands, t.participant, t.hand);
  if (hand == hands.end() || !is_finite(t.target) || t.target.p.cwiseAbs().maxCoeff() > max_coordinate)
    return;
  hand->target = {t.target.p, t.target.q.normalized()};
  hand->draws = t.draws;
  hand->reaction = t.reaction && std::isfinite(*t.reaction) ? t.reaction : std::nullopt;
  if (std::all_of(t.flexion.begin(), t.flexion.end(), [](double f) { return std::isfinite(f); }))
    hand->target_flexion = t.flexion;
}

}  // namespace

void take_inputs(State& state, Colliders& colliders, const TickInput& input, StepReport& report) {
  Bodies& bodies = state.bodies;
  for (const EffortChange& change : input.efforts) take(change, bodies);
  for (hands::Hand& hand : state.hands) hand.previous_target = hand.target;
  for (const HandEvent& event : input.events) take(event, input.targets, state, colliders, report);
  for (const PartEvent& event : input.parts) report.part_answers.push_back(obey(state, event, report));
  for (const HandTarget& target : input.targets) take(target, state.hands);
  if (state.panels) {
    for (const panel::HeadPlace& head : input.heads) state.panels->take(head);
    for (const panel::HeldPlace& held : input.held) state.panels->take(held);
    for (const panel::PanelEvent& event : input.panels) state.panels->take(event, PanelStation(state));
  }
  bend_fingers(state, colliders);
  for (const hands::Hand& hand : state.hands)
    if (hand.hold && !bodies.is_soft(hand.hold->body)) bodies.rigid.wake(hand.hold->body);
  for (const KinematicTarget& d : input.kinematic_targets) drive(bodies, d, report);
}

}  // namespace prosector
