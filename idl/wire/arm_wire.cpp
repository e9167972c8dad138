// Wire conversion of haptic arm messages: FeltPlanes, ArmForce.

#include <cmath>

#include "idl/wire/fields.h"

namespace prosector {
namespace {

constexpr double max_arm_length = 1;  // m: distance of a contact point from the hand's origin

Refusal check_plane(const ContactPlane& m) {
  return Checks()
      .that(m.body < max_bodies, "no such body")
      .that(within(m.arm, max_arm_length), "the contact point of a contact plane is too far from the hand")
      .that(within(m.point, max_coordinate), "point out of range")
      .that(m.normal.allFinite() && std::abs(m.normal.norm() - 1) <= quaternion_slack,
            "normal not of unit length")
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

template <class Io>
void fields(Io& io, MessageOf<Io, ContactPlane>& m, WireOf<Io, prosector_ContactPlane>& w) {
  io(m.id, w.id);
  io(m.body, w.body);
  io(m.arm, w.arm);
  io(m.point, w.place);
  io(m.normal, w.normal);
  io(m.force, w.force);
  io(m.stiffness, w.stiffness);
  io(m.tangential, w.tangential);
  io(m.damping, w.damping);
  io(m.friction, w.friction);
  io(m.radius, w.radius);
  io(m.velocity, w.velocity);
  io(m.holds, w.holds);
}

template <class Io>
void fields(Io& io, MessageOf<Io, FeltPlanes>& m, WireOf<Io, prosector_FeltPlanes>& w) {
  io(m.participant, w.participant);
  io(m.hand, w.hand);
  io(m.time, w.time);
  io(m.input_sequence, w.input_number);
  io.list(m.planes, w.planes, max_contact_planes, "too many planes",
          [](auto& items, auto& plane, auto& field) { fields(items, plane, field); });
  io(m.taken, w.taken);
  io(m.given, w.given);
}

template <class Io>
void fields(Io& io, MessageOf<Io, ArmForce>& m, WireOf<Io, prosector_ArmForce>& w) {
  io(m.participant, w.participant);
  io(m.hand, w.hand);
  io(m.sequence, w.number);
  io(m.force, w.force);
  io(m.taken, w.taken);
  io(m.given, w.given);
}

}  // namespace

PROSECTOR_WIRE_BY_FIELDS(FeltPlanes);

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

PROSECTOR_WIRE_BY_FIELDS(ArmForce);

Refusal check(ArmForce& m) {
  Checks checks;
  return check_energies(checks, m.participant, m.hand, m.taken, m.given)
      .that(within(m.force, max_arm_force), "force out of range")
      .refusal();
}

}  // namespace prosector
