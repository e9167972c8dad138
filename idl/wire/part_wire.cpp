// Wire conversion of the state of parts, panels and the room: PartState, Panel, RoomState.

#include "idl/wire/fields.h"

namespace prosector {
namespace {

template <class Io>
void fields(Io& io, MessageOf<Io, HandRef>& m, WireOf<Io, prosector_HandRef>& w) {
  io(m.participant, w.participant);
  io(m.hand, w.hand);
}

template <class Io>
void fields(Io& io, MessageOf<Io, PartState>& m, WireOf<Io, prosector_PartState>& w) {
  io(m.body, w.body);
  io(m.time, w.time);
  io(m.attached, w.attached);
  io(m.hidden, w.hidden);
  io(m.lit, w.lit);
  io(m.inspected, w.inspected);
  io(m.opacity, w.opacity);
  io(m.stiffness, w.stiffness);
  io(m.shape, w.shape);
  io.list(m.holders, w.holders, max_holders, "too many holders",
          [](auto& items, auto& holder, auto& field) { fields(items, holder, field); });
}

template <class Io>
void fields(Io& io, MessageOf<Io, ControlState>& m, WireOf<Io, prosector_ControlState>& w) {
  io(m.position, w.position);
  io(m.on, w.on);
  io(m.touched, w.touched);
}

template <class Io>
void fields(Io& io, MessageOf<Io, Panel>& m, WireOf<Io, prosector_Panel>& w) {
  static_assert(sizeof w.controls == panel_control_count * sizeof w.controls[0]);
  io(m.participant, w.participant);
  io(m.time, w.time);
  io(m.open, w.open);
  io(m.body, w.body);
  io(m.pose, w.pose);
  for (std::size_t i = 0; i < panel_control_count; ++i) fields(io, m.controls[i], w.controls[i]);
}

template <class Io>
void fields(Io& io, MessageOf<Io, RoomState>& m, WireOf<Io, prosector_RoomState>& w) {
  io(m.time, w.time);
  io(m.lights, w.lights);
  io(m.pace, w.pace);
}

}  // namespace

PROSECTOR_WIRE_BY_FIELDS(PartState);

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

PROSECTOR_WIRE_BY_FIELDS(Panel);

Refusal check(Panel& m) {
  if (const Refusal pose = check_pose(m.pose)) return pose;
  Checks checks;
  checks.that(m.participant != 0, "participant id 0").that(m.body < max_bodies, "no such body");
  for (const ControlState& control : m.controls)
    checks.that(within(control.position, 0, 1), "control out of range");
  return checks.refusal();
}

PROSECTOR_WIRE_BY_FIELDS(RoomState);

Refusal check(RoomState& m) {
  return Checks()
      .that(within(m.lights, 0, 1), "brightness outside [0, 1]")
      .that(within(m.pace, 0, max_pace), "the pace of simulated time is out of range")
      .refusal();
}

}  // namespace prosector
