// What people ask for and are answered: Command, CommandResult.

#include "idl/wire/primitives.h"

namespace prosector {

void to_wire(const Command& m, prosector_Command& w, WireArena&) {
  w.participant = m.participant;
  w.number = m.sequence;
  w.kind = static_cast<std::uint8_t>(m.kind);
  w.hand = m.hand;
  w.body = m.body;
  w.subject = m.subject;
  w.role = static_cast<std::uint8_t>(m.role);
  w.shape = to_wire(m.shape);
  w.control_id = static_cast<std::uint8_t>(m.control);
  w.value = m.value;
  w.revision = m.revision;
}

Refusal from_wire(const prosector_Command& w, Command& m) {
  m.participant = w.participant;
  m.sequence = w.number;
  m.kind = static_cast<CommandKind>(w.kind);
  m.hand = w.hand;
  m.body = w.body;
  m.subject = w.subject;
  m.role = static_cast<Role>(w.role);
  m.shape = from_wire(w.shape);
  m.control = static_cast<PanelControl>(w.control_id);
  m.value = w.value;
  m.revision = w.revision;
  return {};
}

namespace {

/// Returns the largest value that a command of that kind may have.
double most_value(CommandKind kind) {
  if (kind == CommandKind::set_pace) return most_pace;
  return kind == CommandKind::set_accuracy ? most_accuracy : 1;
}

}  // namespace

Refusal check(Command& m) {
  if (const Refusal shape = check_shape(m.shape)) return shape;
  return Checks()
      .that(m.participant != 0, "participant id 0")
      .that(enum_within(m.kind, last_command), "unknown kind")
      .that(enum_within(m.role, Role::host), "unknown role")
      .that(enum_within(m.control, PanelControl::stiffness), "unknown control")
      .that(within(m.value, 0, most_value(m.kind)), "value out of range")
      .that(m.hand <= right_hand, "no such hand")
      .that(m.body < max_bodies, "no such body")
      .refusal();
}

void to_wire(const CommandResult& m, prosector_CommandResult& w, WireArena&) {
  w.participant = m.participant;
  w.number = m.sequence;
  w.accepted = m.accepted;
  to_wire(m.reason, w.reason);
}

Refusal from_wire(const prosector_CommandResult& w, CommandResult& m) {
  m.participant = w.participant;
  m.sequence = w.number;
  m.accepted = w.accepted != 0;
  m.reason = from_wire(w.reason);
  return {};
}

Refusal check(CommandResult& m) {
  return Checks()
      .that(m.participant != 0, "participant id 0")
      .that(valid_text(m.reason), "reason not valid text")
      .refusal();
}

}  // namespace prosector
