// Wire conversion of the state of parts, panels and the room: PartState, Panel, RoomState.

#include "idl/wire/primitives.h"

namespace prosector {

void to_wire(const PartState& m, prosector_PartState& w, WireArena& arena) {
  w.body = m.body;
  w.time = to_wire(m.time);
  w.attached = m.attached;
  w.hidden = m.hidden;
  w.lit = m.lit;
  w.inspected = m.inspected;
  w.opacity = m.opacity;
  w.stiffness = m.stiffness;
  w.shape = to_wire(m.shape);
  make_sequence<prosector_HandRef>(w.holders, m.holders.size(), arena);
  for (std::size_t i = 0; i < m.holders.size(); ++i)
    w.holders._buffer[i] = {m.holders[i].participant, m.holders[i].hand};
}

Refusal from_wire(const prosector_PartState& w, PartState& m) {
  if (!sequence_within(w.holders, max_holders)) return "too many holders";
  m.body = w.body;
  m.time = from_wire(w.time);
  m.attached = w.attached != 0;
  m.hidden = w.hidden != 0;
  m.lit = w.lit != 0;
  m.inspected = w.inspected != 0;
  m.opacity = w.opacity;
  m.stiffness = w.stiffness;
  m.shape = from_wire(w.shape);
  m.holders.clear();
  for (std::size_t i = 0; i < w.holders._length; ++i)
    m.holders.push_back({w.holders._buffer[i].participant, w.holders._buffer[i].hand});
  return {};
}

Refusal check(PartState& m) {
  if (const Refusal shape = check_shape(m.shape)) return shape;
  Checks checks;
  checks.that(m.body < max_bodies, "no such body")
      .that(within(m.opacity, 0, 1), "opacity outside [0, 1]")
      .that(within(m.stiffness, min_stiffness, max_stiffness), "stiffness out of range")
      .that(m.holders.size() <= max_holders, "too many holders");
  for (const HandRef& holder : m.holders)
    checks.that(holder.participant != 0, "participant id 0").that(holder.hand <= right_hand, "no such hand");
  return checks.refusal();
}

void to_wire(const Panel& m, prosector_Panel& w, WireArena&) {
  static_assert(sizeof w.controls == panel_control_count * sizeof w.controls[0]);
  w.participant = m.participant;
  w.time = to_wire(m.time);
  w.open = m.open;
  w.body = m.body;
  to_wire(m.pose, w.pose);
  for (std::size_t i = 0; i < panel_control_count; ++i)
    w.controls[i] = {m.controls[i].position, m.controls[i].on, m.controls[i].touched};
}

Refusal from_wire(const prosector_Panel& w, Panel& m) {
  m.participant = w.participant;
  m.time = from_wire(w.time);
  m.open = w.open != 0;
  m.body = w.body;
  m.pose = from_wire(w.pose);
  for (std::size_t i = 0; i < panel_control_count; ++i)
    m.controls[i] = {w.controls[i].position, w.controls[i].on != 0, w.controls[i].touched != 0};
  return {};
}

Refusal check(Panel& m) {
  if (const Refusal pose = check_pose(m.pose)) return pose;
  Checks checks;
  checks.that(m.participant != 0, "participant id 0").that(m.body < max_bodies, "no such body");
  for (const ControlState& control : m.controls)
    checks.that(within(control.position, 0, 1), "control out of range");
  return checks.refusal();
}

void to_wire(const RoomState& m, prosector_RoomState& w, WireArena&) {
  w.time = to_wire(m.time);
  w.lights = m.lights;
  w.pace = m.pace;
}

Refusal from_wire(const prosector_RoomState& w, RoomState& m) {
  m.time = from_wire(w.time);
  m.lights = w.lights;
  m.pace = w.pace;
  return {};
}

Refusal check(RoomState& m) {
  return Checks()
      .that(within(m.lights, 0, 1), "brightness outside [0, 1]")
      .that(within(m.pace, 0, max_pace), "pace out of range")
      .refusal();
}

}  // namespace prosector
