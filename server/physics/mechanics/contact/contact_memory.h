#pragma once
// State of tissue contacts that is carried from one tick to the next.
//
// Smoothed friction resists motion only: under a steady load a body at rest creeps slowly. So the slip of
// each contact is measured from the point where it last slid, like a spring's extension (Cundall and Strack
// 1979). The contact carries load at rest and yields by one slip threshold before it slides. A vertex that is
// pressed deep into a body must leave where it entered: vertex_gap.h.
//
// Contacts on faces appear, vanish or stiffen while they are deep. A spring that stiffens while it is
// compressed returns more energy than it stored. So such a contact continues with the previous force. Its gap
// is measured from a rest gap below 0. The rest gap rises to 0 slowly, or as fast as the gap opens.

#include <span>
#include <vector>

#include "server/physics/mechanics/contact/contact.h"

namespace prosector::contact {

/// State of one contact of a soft body that is stored from one tick to the next: friction slip, force,
/// normal, stiffness and rest gap.
struct ContactMemory {
  bool soft = false;            // whether the other side is a soft body, not a rigid one
  std::size_t body = 0;         // of the other side: index of the soft body, or slot of the rigid one
  std::uint32_t feature = 0;    // of the soft surface, as Contact::feature
  std::uint32_t met = 0;        // as Contact::met
  Vec3 grip = Vec3::Zero();     // as Contact::grip
  double force = 0;             // N, normal
  Vec3 normal = Vec3::UnitY();  // as Contact::normal
  double stiffness = 0;         // N/m
  double rest = 0;              // m, as Contact::rest
};

/// Stored contact states of one soft body, sorted by (soft, body, feature, met).
using ContactMemories = std::vector<ContactMemory>;

/// Finds the stored state of the contact of a soft body's surface feature (vertex or face point) with the
/// body of side `other`. `met`: for sheets and ropes, the other side's feature. Returns null if this contact
/// did not press in the last tick.
const ContactMemory* find(const ContactMemories& memories, const ContactSide& other, std::uint32_t feature,
                          std::uint32_t met = 0);

/// Finds the stored state of a contact between thin bodies (sheets or ropes). If there is none, finds the
/// strongest one of the same corner or edge with another part of the other body, on the same side of it.
/// Returns null if there is none either.
const ContactMemory* find_layer(const ContactMemories& memories, const Contact& contact);

/// Sets the contact's friction slip and previous normal force from its stored state. Does nothing if `memory`
/// is null.
void recall(const ContactMemory* memory, Contact& contact);

/// Sets the rest gaps (gaps at which the force is zero) of contacts on faces, so that a contact that appears,
/// stiffens or replaces another one continues the previous force. Faces are the features from `first_face`
/// on. `contacts`: all contacts of the soft body with one other body. `h`: tick length, s.
void rest(const ContactMemories& memories, std::uint32_t first_face, double h, std::span<Contact> contacts);

/// Returns whether the stored state is valid: all numbers are finite, force and stiffness are positive, and
/// the rest gap is not positive. Others are neither stored by keep() nor accepted from a checkpoint.
bool is_consistent(const ContactMemory& memory);

/// Replaces the stored contact states of soft body `body` by the states of this tick's contacts, after the
/// tick was solved.
void keep(std::span<const Contact> contacts, std::size_t body, ContactMemories& memories);

}  // namespace prosector::contact
