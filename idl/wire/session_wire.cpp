// Wire conversion of the session and its participants: SessionInfo, Presence, RosterEntry.

#include "idl/wire/primitives.h"

namespace prosector {

void to_wire(const SessionInfo& m, prosector_SessionInfo& w, WireArena&) {
  to_wire(m.session, w.session);
  w.server_run = m.server_run;
  w.version = m.version;
  to_wire(m.scene, w.scene);
  w.scene_hash = to_wire(m.scene_hash);
  w.tick_rate = m.tick_rate;
  w.capacity = m.capacity;
}

Refusal from_wire(const prosector_SessionInfo& w, SessionInfo& m) {
  m.session = from_wire(w.session);
  m.server_run = w.server_run;
  m.version = w.version;
  m.scene = from_wire(w.scene);
  m.scene_hash = from_wire(w.scene_hash);
  m.tick_rate = w.tick_rate;
  m.capacity = w.capacity;
  return {};
}

Refusal check(SessionInfo& m) {
  Checks checks;
  checks.that(valid_name(m.session), "session name not valid");
  if (m.version == protocol_version)  // the other fields may have another meaning in another version
    checks.that(valid_name(m.scene), "scene name not valid")
        .that(within(m.tick_rate, 1, 10000), "the session's tick rate is out of range");
  return checks.refusal();
}

void to_wire(const Presence& m, prosector_Presence& w, WireArena&) {
  w.participant = m.participant;
  w.version = m.version;
  to_wire(m.name, w.name);
  w.role = static_cast<std::uint8_t>(m.role);
  to_wire(m.devices, w.devices);
  w.arms = m.arms;
}

Refusal from_wire(const prosector_Presence& w, Presence& m) {
  m.participant = w.participant;
  m.version = w.version;
  m.name = from_wire(w.name);
  m.role = static_cast<Role>(w.role);
  m.devices = from_wire(w.devices);
  m.arms = w.arms;
  return {};
}

Refusal check(Presence& m) {
  Checks checks;
  checks.that(m.participant != 0, "participant id 0").that(valid_name(m.name), "name not valid");
  if (m.version == protocol_version)
    checks.that(enum_within(m.role, Role::host), "unknown role")
        .that(valid_text(m.devices), "devices not valid text")
        .that(m.arms <= 3, "arms for unknown hands");
  return checks.refusal();
}

void to_wire(const RosterEntry& m, prosector_RosterEntry& w, WireArena&) {
  w.participant = m.participant;
  to_wire(m.name, w.name);
  w.role = static_cast<std::uint8_t>(m.role);
  to_wire(m.color, w.color);
  to_wire(m.devices, w.devices);
}

Refusal from_wire(const prosector_RosterEntry& w, RosterEntry& m) {
  m.participant = w.participant;
  m.name = from_wire(w.name);
  m.role = static_cast<Role>(w.role);
  m.color = from_wire(w.color);
  m.devices = from_wire(w.devices);
  return {};
}

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
