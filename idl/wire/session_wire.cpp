// Wire conversion of the session and its participants: SessionInfo, Presence, RosterEntry.

#include "idl/wire/fields.h"

namespace prosector {
namespace {

template <class Io>
void fields(Io& io, MessageOf<Io, SessionInfo>& m, WireOf<Io, prosector_SessionInfo>& w) {
  io(m.session, w.session);
  io(m.server_run, w.server_run);
  io(m.version, w.version);
  io(m.scene, w.scene);
  io(m.scene_hash, w.scene_hash);
  io(m.tick_rate, w.tick_rate);
  io(m.capacity, w.capacity);
}

template <class Io>
void fields(Io& io, MessageOf<Io, Presence>& m, WireOf<Io, prosector_Presence>& w) {
  io(m.participant, w.participant);
  io(m.version, w.version);
  io(m.name, w.name);
  io(m.role, w.role);
  io(m.devices, w.devices);
  io(m.arms, w.arms);
}

template <class Io>
void fields(Io& io, MessageOf<Io, RosterEntry>& m, WireOf<Io, prosector_RosterEntry>& w) {
  io(m.participant, w.participant);
  io(m.name, w.name);
  io(m.role, w.role);
  io(m.color, w.color);
  io(m.devices, w.devices);
}

}  // namespace

PROSECTOR_WIRE_BY_FIELDS(SessionInfo);

Refusal check(SessionInfo& m) {
  Checks checks;
  checks.that(valid_name(m.session), "session name not valid");
  if (m.version == protocol_version)  // the other fields may have another meaning in another version
    checks.that(valid_name(m.scene), "scene name not valid")
        .that(within(m.tick_rate, 1, 10000), "the session's tick rate is out of range");
  return checks.refusal();
}

PROSECTOR_WIRE_BY_FIELDS(Presence);

Refusal check(Presence& m) {
  Checks checks;
  checks.that(m.participant != 0, "participant id 0").that(valid_name(m.name), "name not valid");
  if (m.version == protocol_version)
    checks.that(enum_within(m.role, Role::host), "unknown role")
        .that(valid_text(m.devices), "devices not valid text")
        .that(m.arms <= 3, "the set of hands with haptic arms is out of range");
  return checks.refusal();
}

PROSECTOR_WIRE_BY_FIELDS(RosterEntry);

Refusal check(RosterEntry& m) {
  if (const Refusal color = check_color(m.color)) return color;
  return Checks()
      .that(m.participant != 0, "participant id 0")
      .that(valid_name(m.name), "name not valid")
      .that(enum_within(m.role, Role::host), "unknown role")
      .that(valid_text(m.devices), "devices not valid text")
      .refusal();
}

}  // namespace prosector
