#include "server/physics/stations/panels/panel_station.h"

#include <algorithm>
#include <vector>

#include "common/hand.h"
#include "common/index_tip.h"
#include "server/physics/stations/parts/part_rules.h"

namespace prosector {
namespace {

constexpr double seen_through = 0.35;  // opacity of a transparent part
constexpr double bent = 0.7;           // flexion beyond which a finger counts as part of a fist
constexpr double dimmed = 0.25;        // brightness of the room's lights when dimmed

/// Returns the hands as input for panels, in canonical order.
std::vector<panel::PanelHand> panel_hands(const State& state, std::span<const HandState> hand_states) {
  std::vector<panel::PanelHand> out;
  for (std::size_t i = 0; i < state.hands.size(); ++i) {
    const hands::Hand& hand = state.hands[i];
    const HandState& shown = hand_states[i];
    const Pose centre = state.bodies.rigid.motion(hand.slot).pose;
    panel::PanelHand& felt = out.emplace_back();
    felt.who = {hand.participant, static_cast<std::uint8_t>(hand.side)};
    felt.palm = felt.touched_at = centre.p;
    const auto poses =
        hands::hand_part_poses(hand.side, hand.flexion, state.bodies.model.hands[hand.side].center);
    for (const HandSegment& s : hand_segments(hand.side)) {
      const Pose segment = centre * poses[s.joint + 1];
      felt.fingers.push_back(
          {segment * Vec3(0, -s.length / 2, 0), segment * Vec3(0, s.length / 2, 0), s.radius});
    }
    felt.index = felt.fingers[index_end];
    felt.bend = *std::min_element(hand.target_flexion.begin() + 1, hand.target_flexion.end());
    felt.fist = !hand.hold && felt.bend > bent;
    if (shown.contact.touching) {
      felt.touches = shown.contact.body;
      felt.touched_at = shown.contact.point;
    } else if (hand.hold) {
      felt.touches = hand.hold->body;
    }
  }
  return out;
}

/// Applies a control's request. If a part refuses (for example too far from its place to be attached), it
/// stays unchanged, its control shows that, and the report has the reason.
void carry_out(State& state, const panel::PanelAction& action, StepReport& report) {
  using Kind = PartEvent::Kind;
  const bool on = action.value >= 0.5;
  const auto apply = [&](Kind kind, BodyId body, double value = 0) {
    const Refusal refusal = obey(
        state, {.kind = kind, .participant = action.participant, .body = body, .shape = {}, .value = value},
        report);
    if (refusal) report.panel_refusals.push_back({action.participant, refusal.why()});
  };
  switch (action.control) {
    case PanelControl::attach:
      return apply(on ? Kind::attach : Kind::detach, action.body);
    case PanelControl::hide_others:
      for (BodyId other = 0; other < state.bodies.parts.size(); ++other)
        if (other != action.body && state.bodies.is_part(other)) apply(on ? Kind::hide : Kind::show, other);
      return;
    case PanelControl::transparency:
      return apply(Kind::set_opacity, action.body, on ? seen_through : 1);
    case PanelControl::light_shaft:
      return apply(Kind::light, action.body, action.value);
    case PanelControl::room_lights:
      state.room_lights = on ? 1 : dimmed;
      return;
    case PanelControl::stiffness:
      return apply(Kind::set_stiffness, action.body,
                   std::clamp(stiffness_at(action.value), min_stiffness, max_stiffness));
  }
}

}  // namespace

bool PanelStation::has_panel(BodyId body) const {
  const Bodies& bodies = state_.bodies;
  return body < bodies.parts.size() && bodies.is_part(body) && !bodies.parts[body].out_of_touch();
}

std::pair<Vec3, Vec3> PanelStation::box(BodyId body) const {
  const Bodies& bodies = state_.bodies;
  if (!bodies.is_soft(body)) return bodies.rigid.bounds(body, 0);
  const contact::SurfaceDetector& surface = bodies.soft[bodies.soft_index(body)].surface.vertices();
  return {surface.lo(), surface.hi()};
}

panel::ShownControls PanelStation::shown(BodyId body) const {
  const Bodies& bodies = state_.bodies;
  const Part& part = bodies.parts[body];
  bool alone = false, seen = false;  // whether there are other parts; whether one of them is visible
  for (BodyId other = 0; other < bodies.parts.size(); ++other) {
    if (other == body || !bodies.is_part(other)) continue;
    alone = true;
    seen = seen || !bodies.parts[other].hidden;
  }
  panel::ShownControls out{};
  const auto set = [&](PanelControl control, double value) {
    out[static_cast<std::size_t>(control)] = value;
  };
  set(PanelControl::attach, part.attached ? 1 : 0);
  set(PanelControl::hide_others, alone && !seen ? 1 : 0);
  set(PanelControl::transparency, part.opacity < 1 ? 1 : 0);
  set(PanelControl::light_shaft, part.lit ? 1 : 0);
  set(PanelControl::room_lights, state_.room_lights == 1 ? 1 : 0);
  set(PanelControl::stiffness, std::clamp(position_of_stiffness(part.stiffness), 0.0, 1.0));
  return out;
}

std::optional<BodyId> PanelStation::first() const {
  for (BodyId body = 0; body < state_.bodies.parts.size(); ++body)
    if (has_panel(body)) return body;
  return std::nullopt;
}

void step_panels(State& state, std::span<const HandState> hand_states, StepReport& report) {
  if (!state.panels) return;
  const PanelStation subjects(state);
  for (const panel::PanelAction& action : state.panels->step(panel_hands(state, hand_states), subjects))
    carry_out(state, action, report);
  state.panels->show(subjects);
  report.panel_carriers = state.panels->carriers();
}

}  // namespace prosector
