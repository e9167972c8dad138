// Panels: hands press their controls, controls change parts and room.

#include <algorithm>

#include "common/hand.h"
#include "server/physics/simulation_impl.h"

namespace prosector {
namespace {

constexpr double seen_through = 0.35;  // opacity of a part that is made transparent
constexpr double dimmed = 0.25;        // brightness of the room's lights

}  // namespace

bool Simulation::Impl::has_panel(BodyId body) const {
  return body < parts.size() && is_part(body) && !parts[body].out_of_touch();
}

std::pair<Vec3, Vec3> Simulation::Impl::box(BodyId body) const {
  if (!is_soft(body)) return world.bounds(body, 0);
  const SurfaceDetector& surface = surfaces[soft_index(body)];
  return {surface.lo(), surface.hi()};
}

ShownControls Simulation::Impl::shown(BodyId body) const {
  const Part& part = parts[body];
  bool alone = false, seen = false;  // other parts there are; one of them is seen
  for (BodyId other = 0; other < parts.size(); ++other) {
    if (other == body || !is_part(other)) continue;
    alone = true;
    seen = seen || !parts[other].hidden;
  }
  ShownControls out{};
  const auto set = [&](PanelControl control, double value) {
    out[static_cast<std::size_t>(control)] = value;
  };
  set(PanelControl::attach, part.attached ? 1 : 0);
  set(PanelControl::hide_others, alone && !seen ? 1 : 0);
  set(PanelControl::transparency, part.opacity < 1 ? 1 : 0);
  set(PanelControl::light_shaft, part.lit ? 1 : 0);
  set(PanelControl::room_lights, room_lights == 1 ? 1 : 0);
  set(PanelControl::stiffness, std::clamp(position_of_stiffness(part.stiffness), 0.0, 1.0));
  return out;
}

/// Hands as panels feel them, in canonical order.
std::vector<PanelHand> Simulation::Impl::panel_hands() const {
  std::vector<PanelHand> out;
  for (std::size_t i = 0; i < hands.size(); ++i) {
    const Hand& hand = hands[i];
    const HandState& state = hand_states[i];
    const Pose centre = world.motion(hand.slot).pose;
    PanelHand& felt = out.emplace_back();
    felt.who = {hand.participant, static_cast<std::uint8_t>(hand.side)};
    felt.palm = felt.touched_at = centre.p;
    const auto poses = hand_part_poses(hand.side, hand.flexion, model.hands[hand.side].center);
    for (const HandSegment& s : hand_segments(hand.side)) {
      const Pose segment = centre * poses[s.joint + 1];
      felt.fingers.push_back(
          {segment * Vec3(0, -s.length / 2, 0), segment * Vec3(0, s.length / 2, 0), s.radius});
    }
    if (state.contact.touching) {
      felt.touches = state.contact.body;
      felt.touched_at = state.contact.point;
    } else if (hand.hold) {
      felt.touches = hand.hold->body;
    }
  }
  return out;
}

void Simulation::Impl::step_panels() {
  if (!panels) return;
  describe_hands();
  for (const PanelAction& action : panels->step(panel_hands(), *this)) carry_out(action);
  panels->show(*this);
}

/// A part that refuses (it is too far from its place to be attached) stays as it is, and its control shows
/// it.
void Simulation::Impl::carry_out(const PanelAction& action) {
  using Kind = PartEvent::Kind;
  const bool on = action.value >= 0.5;
  const auto tell = [&](Kind kind, BodyId body, double value = 0) {
    obey({.kind = kind, .participant = action.participant, .body = body, .shape = {}, .value = value});
  };
  switch (action.control) {
    case PanelControl::attach:
      return tell(on ? Kind::attach : Kind::detach, action.body);
    case PanelControl::hide_others:
      for (BodyId other = 0; other < parts.size(); ++other)
        if (other != action.body && is_part(other)) tell(on ? Kind::hide : Kind::show, other);
      return;
    case PanelControl::transparency:
      return tell(Kind::set_opacity, action.body, on ? seen_through : 1);
    case PanelControl::light_shaft:
      return tell(Kind::light, action.body, action.value);
    case PanelControl::room_lights:
      room_lights = on ? 1 : dimmed;
      return;
    case PanelControl::stiffness:
      return tell(Kind::set_stiffness, action.body,
                  std::clamp(stiffness_at(action.value), least_stiffness, most_stiffness));
  }
}

}  // namespace prosector
