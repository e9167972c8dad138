#pragma once
// State of tissue contacts that is carried from one tick to the next.
//
// Smoothed friction resists motion only: under a steady load a body at rest creeps slowly. So the slip of
// each contact is measured from the point where it last slid, like a spring's extension (Cundall and Strack
// 1979). The contact carries load at rest and yields by one slip threshold before it slides. A vertex that is
// pressed deep into a body must leave where it entered: facing.h.
//
// Contacts on faces appear, vanish or stiffen while they are deep. A spring that stiffens while it is
// compressed returns more energy than it stored. So such a contact continues with the previous force. Its gap
// is measured from a rest gap below 0. The rest gap rises to 0 slowly, or as fast as the gap opens.

#include <span>
#include <vector>

#include "server/physics/mechanics/contact/contact.h"

namespace prosector {

/// Stored state of one contact.
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

/// The contact memories of one soft body, ordered by (soft, body, feature, met).
using ContactMemories = std::vector<ContactMemory>;

/// Finds the memory of a contact; null: it did not press in the last tick.
const ContactMemory* find(const ContactMemories& memories, const ContactSide& other, std::uint32_t feature,
                          std::uint32_t met = 0);

/// Finds the memory of this layer contact. Without one, finds the strongest memory of the same corner or edge
/// on the same side, with another part of the other layer.
const ContactMemory* find_layer(const ContactMemories& memories, const Contact& contact);

/// Restores a contact's friction state from its memory.
void recall(const ContactMemory* memory, Contact& contact);

/// Sets the rest gaps of contacts on faces (features from `first_face` on), so that their forces do not jump.
/// `contacts`: all of the body's contacts with one other side. h: s, the tick.
void rest(const ContactMemories& memories, std::uint32_t first_face, double h, std::span<Contact> contacts);

/// Returns whether all numbers are finite, force and stiffness are positive, and the rest gap is <= 0. keep()
/// stores no other memory, and a checkpoint with another one is refused.
bool is_consistent(const ContactMemory& memory);

/// Replaces the memories of soft body `body` by those of the tick's contacts.
void keep(std::span<const Contact> contacts, std::size_t body, ContactMemories& memories);

}  // namespace prosector
