// Wire conversion of haptic arm messages: FeltPlanes, ArmForce.

#include <cmath>

#include "idl/wire/primitives.h"

namespace prosector {
namespace {

constexpr double max_arm_length = 1;  // m: distance of a contact point from the hand's origin

void plane_to_wire(const ContactPlane& m, prosector_ContactPlane& w) {
  w.id = m.id;
  w.body = m.body;
  to_wire(m.arm, w.arm);
  to_wire(m.point, w.place);
  to_wire(m.normal, w.normal);
  to_wire(m.force, w.force);
  w.stiffness = static_cast<float>(m.stiffness);
  w.tangential = static_cast<float>(m.tangential);
  w.damping = static_cast<float>(m.damping);
  w.friction = static_cast<float>(m.friction);
  w.radius = static_cast<float>(m.radius);
  to_wire(m.velocity, w.velocity);
  w.holds = m.holds;
}

ContactPlane plane_from_wire(const prosector_ContactPlane& w) {
  ContactPlane m;
  m.id = w.id;
  m.body = w.body;
  m.arm = from_wire(w.arm);
  m.point = from_wire(w.place);
  m.normal = from_wire(w.normal);
  m.force = from_wire(w.force);
  m.stiffness = w.stiffness;
  m.tangential = w.tangential;
  m.damping = w.damping;
  m.friction = w.friction;
  m.radius = w.radius;
  m.velocity = from_wire(w.velocity);
  m.holds = w.holds != 0;
  return m;
}

Refusal check_plane(const ContactPlane& m) {
  return Checks()
      .that(m.body < max_bodies, "no such body")
      .that(within(m.arm, max_arm_length), "the contact point of a contact plane is too far from the hand")
      .that(within(m.point, max_coordinate), "point out of range")
      .that(m.normal.allFinite() && std::abs(m.normal.norm() - 1) <= quaternion_slack, "normal not unit")
      .that(within(m.force, max_plane_force), "force out of range")
      .that(within(m.stiffness, 0, max_plane_stiffness), "stiffness out of range")
      .that(within(m.tangential, 0, max_plane_stiffness), "stiffness out of range")
      .that(within(m.damping, 0, max_plane_damping), "damping out of range")
      .that(within(m.friction, 0, max_plane_friction), "friction out of range")
      .that(within(m.radius, 0, max_coordinate), "radius out of range")
      .that(within(m.velocity, max_plane_speed), "velocity out of range")
      .refusal();
}

/// Adds the checks that both messages share.
Checks& check_energies(Checks& checks, ParticipantId participant, std::uint8_t hand, double taken,
                       double given) {
  return checks.that(participant != 0, "participant id 0")
      .that(hand <= right_hand, "no such hand")
      .that(within(taken, 0, max_arm_energy) && within(given, 0, max_arm_energy), "energy out of range");
}

}  // namespace

void to_wire(const FeltPlanes& m, prosector_FeltPlanes& w, WireArena& arena) {
  w.participant = m.participant;
  w.hand = m.hand;
  w.time = to_wire(m.time);
  w.input_number = m.input_sequence;
  make_sequence<prosector_ContactPlane>(w.planes, m.planes.size(), arena);
  for (std::size_t i = 0; i < m.planes.size(); ++i) plane_to_wire(m.planes[i], w.planes._buffer[i]);
  w.taken = m.taken;
  w.given = m.given;
}

Refusal from_wire(const prosector_FeltPlanes& w, FeltPlanes& m) {
  if (!sequence_within(w.planes, max_contact_planes)) return "too many planes";
  m.participant = w.participant;
  m.hand = w.hand;
  m.time = from_wire(w.time);
  m.input_sequence = w.input_number;
  m.planes.clear();
  for (std::size_t i = 0; i < w.planes._length; ++i) m.planes.push_back(plane_from_wire(w.planes._buffer[i]));
  m.taken = w.taken;
  m.given = w.given;
  return {};
}

Refusal check(FeltPlanes& m) {
  for (ContactPlane& plane : m.planes) {
    if (const Refusal refusal = check_plane(plane)) return refusal;
    plane.normal.normalize();
  }
  Checks checks;
  return check_energies(checks, m.participant, m.hand, m.taken, m.given)
      .that(m.planes.size() <= max_contact_planes, "too many planes")
      .refusal();
}

void to_wire(const ArmForce& m, prosector_ArmForce& w, WireArena&) {
  w.participant = m.participant;
  w.hand = m.hand;
  w.number = m.sequence;
  to_wire(m.force, w.force);
  w.taken = m.taken;
  w.given = m.given;
}

Refusal from_wire(const prosector_ArmForce& w, ArmForce& m) {
  m.participant = w.participant;
  m.hand = w.hand;
  m.sequence = w.number;
  m.force = from_wire(w.force);
  m.taken = w.taken;
  m.given = w.given;
  return {};
}

Refusal check(ArmForce& m) {
  Checks checks;
  return check_energies(checks, m.participant, m.hand, m.taken, m.given)
      .that(within(m.force, max_arm_force), "force out of range")
      .refusal();
}

}  // namespace prosector
