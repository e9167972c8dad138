// Requests of participants and their answers: Command, CommandResult.
//
// On the wire all commands share one struct, whose fields mean something else from command to command. Each
// command is described once, for writing and for reading: an Io puts each member into its field, or takes it
// from there. Structured bindings name all members, so that a new member doesn't compile until it is added
// here.

#include <array>
#include <type_traits>
#include <utility>

#include "idl/wire/fields.h"

namespace prosector {
namespace {

constexpr std::uint32_t grasp_named_body =
    1;  // `revision` of a grasp that prefers `body`; else the nearest is meant

/// An Io that writes members to the fields of a command.
class CommandFieldWriter {
 public:
  template <class T>
  using Entry = const T;

  explicit CommandFieldWriter(prosector_Command& fields) : fields_(fields) {}

  void hand(const std::uint8_t& hand) { fields_.hand = hand; }
  void body(const BodyId& body) { fields_.body = body; }
  void preferred(const std::optional<BodyId>& body) {
    fields_.body = body.value_or(0);
    fields_.revision = body ? grasp_named_body : 0;
  }
  void subject(const ParticipantId& subject) { fields_.subject = subject; }
  void role(const Role& role) { fields_.role = static_cast<std::uint8_t>(role); }
  void shape(const Affine& shape) { fields_.shape = to_wire(shape); }
  void position(const Vec3& at) { to_wire(at, fields_.shape.p); }
  void control(const PanelControl& control) { fields_.control_id = static_cast<std::uint8_t>(control); }
  void value(const double& value) { fields_.value = value; }
  void revision(const std::uint32_t& revision) { fields_.revision = revision; }
  void placing(const PanelPlacement& placing) { fields_.revision = static_cast<std::uint32_t>(placing); }

 private:
  prosector_Command& fields_;
};

/// An Io that reads members from the fields of a command.
class CommandFieldReader {
 public:
  template <class T>
  using Entry = T;

  explicit CommandFieldReader(const prosector_Command& fields) : fields_(fields) {}

  void hand(std::uint8_t& hand) { hand = fields_.hand; }
  void body(BodyId& body) { body = fields_.body; }
  void preferred(std::optional<BodyId>& body) {
    if (fields_.revision == grasp_named_body) body = fields_.body;
  }
  void subject(ParticipantId& subject) { subject = fields_.subject; }
  void role(Role& role) { role = static_cast<Role>(fields_.role); }
  void shape(Affine& shape) { shape = from_wire(fields_.shape); }
  void position(Vec3& at) { at = from_wire(fields_.shape.p); }
  void control(PanelControl& control) { control = static_cast<PanelControl>(fields_.control_id); }
  void value(double& value) { value = fields_.value; }
  void revision(std::uint32_t& revision) { revision = fields_.revision; }
  void placing(PanelPlacement& placing) { placing = static_cast<PanelPlacement>(fields_.revision); }

 private:
  const prosector_Command& fields_;
};

template <class Io, class T>
requires std::is_empty_v<T>
void members(Io&, T&) {}

template <class Io>
void members(Io& io, typename Io::template Entry<Grasp>& e) {
  auto& [hand, body] = e;
  io.hand(hand);
  io.preferred(body);
}

template <class Io>
void members(Io& io, typename Io::template Entry<Release>& e) {
  auto& [hand] = e;
  io.hand(hand);
}

template <class Io>
void members(Io& io, typename Io::template Entry<ResetBody>& e) {
  auto& [body, hand] = e;
  io.body(body);
  io.hand(hand);
}

template <class Io>
void members(Io& io, typename Io::template Entry<SetRole>& e) {
  auto& [subject, role] = e;
  io.subject(subject);
  io.role(role);
}

template <class Io>
void members(Io& io, typename Io::template Entry<Detach>& e) {
  auto& [body] = e;
  io.body(body);
}

template <class Io>
void members(Io& io, typename Io::template Entry<Attach>& e) {
  auto& [body] = e;
  io.body(body);
}

template <class Io>
void members(Io& io, typename Io::template Entry<Inspect>& e) {
  auto& [body, shape] = e;
  io.body(body);
  io.shape(shape);
}

template <class Io>
void members(Io& io, typename Io::template Entry<EndInspect>& e) {
  auto& [body] = e;
  io.body(body);
}

template <class Io>
void members(Io& io, typename Io::template Entry<OpenPanel>& e) {
  auto& [body, placing, at] = e;
  io.body(body);
  io.placing(placing);
  io.position(at);
}

template <class Io>
void members(Io& io, typename Io::template Entry<SetControl>& e) {
  auto& [control, value] = e;
  io.control(control);
  io.value(value);
}

template <class Io>
void members(Io& io, typename Io::template Entry<Rewind>& e) {
  auto& [body, revision] = e;
  io.body(body);
  io.revision(revision);
}

template <class Io>
void members(Io& io, typename Io::template Entry<RequestKeyframe>& e) {
  auto& [body] = e;
  io.body(body);
}

template <class Io>
void members(Io& io, typename Io::template Entry<SetPace>& e) {
  auto& [pace] = e;
  io.value(pace);
}

template <class Io>
void members(Io& io, typename Io::template Entry<StepTicks>& e) {
  auto& [ticks] = e;
  io.revision(ticks);
}

template <class Io>
void members(Io& io, typename Io::template Entry<Seek>& e) {
  auto& [tick] = e;
  io.revision(tick);
}

template <class Io>
void members(Io& io, typename Io::template Entry<SetEffort>& e) {
  auto& [body, steps_down] = e;
  io.body(body);
  io.revision(steps_down);
}

template <class Io>
void members(Io& io, typename Io::template Entry<SetAllEfforts>& e) {
  auto& [steps_down] = e;
  io.revision(steps_down);
}

template <class Io>
void members(Io& io, typename Io::template Entry<SetAccuracy>& e) {
  auto& [body, percent] = e;
  io.body(body);
  io.value(percent);
}

/// Returns the wire form of a command. Fields that it doesn't use have fixed values.
prosector_Command fields_of(const Command& m) {
  prosector_Command w{};
  w.participant = m.participant;
  w.number = m.sequence;
  w.kind = static_cast<std::uint8_t>(m.body.index());
  w.hand = right_hand;
  w.shape = to_wire(Affine{});
  CommandFieldWriter io(w);
  std::visit([&](const auto& body) { members(io, body); }, m.body);
  return w;
}

/// Returns the command whose fields passed check_fields().
CommandBody body_of(const prosector_Command& w) {
  static constexpr auto readers = for_each_command([]<class Kind>() {
    return +[](const prosector_Command& fields) {
      Kind body;
      CommandFieldReader io(fields);
      members(io, body);
      return CommandBody(body);
    };
  });
  return readers.at(w.kind)(w);
}

/// Returns the largest value that a command of that kind may have.
double max_command_value(std::size_t kind) {
  if (kind == command_number<SetPace>()) return max_pace;
  return kind == command_number<SetAccuracy>() ? max_accuracy : 1;
}

/// Checks all fields, those that the command doesn't use too.
Refusal check_fields(const prosector_Command& w) {
  if (const Refusal shape = check_shape(from_wire(w.shape))) return shape;
  return Checks()
      .that(w.participant != 0, "participant id 0")
      .that(w.kind < command_kinds, "unknown kind")
      .that(enum_within(static_cast<Role>(w.role), Role::host), "unknown role")
      .that(enum_within(static_cast<PanelControl>(w.control_id), PanelControl::stiffness), "unknown control")
      .that(within(w.value, 0, max_command_value(w.kind)), "value out of range")
      .that(w.hand <= right_hand, "no such hand")
      .that(w.body < max_bodies, "no such body")
      .refusal();
}

template <class Io>
void fields(Io& io, MessageOf<Io, CommandResult>& m, WireOf<Io, prosector_CommandResult>& w) {
  io(m.participant, w.participant);
  io(m.sequence, w.number);
  io(m.accepted, w.accepted);
  io(m.reason, w.reason);
}

}  // namespace

void to_wire(const Command& m, prosector_Command& w, WireArena&) {
  w = fields_of(m);
}

Refusal from_wire(const prosector_Command& w, Command& m) {
  m.participant = w.participant;
  m.sequence = w.number;
  if (const Refusal refusal = check_fields(w)) return refusal;
  m.body = body_of(w);
  return {};
}

Refusal check(Command& m) {
  return check_fields(fields_of(m));
}

PROSECTOR_WIRE_BY_FIELDS(CommandResult);

Refusal check(CommandResult& m) {
  return Checks()
      .that(m.participant != 0, "participant id 0")
      .that(valid_text(m.reason), "reason not valid text")
      .refusal();
}

}  // namespace prosector
