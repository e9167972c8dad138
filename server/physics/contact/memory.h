#pragma once
// What contacts of tissue remember from one tick to the next.
//
// Smoothed friction alone resists motion only: under a steady load a body at rest creeps, however slowly. So
// each contact's slip is counted from where it last let go, as a spring's (Cundall and Strack 1979). It
// carries load at rest, and gives way by one slip threshold before it slides. What is pressed deep into a
// thing must come out where it went in: facing.h.
//
// And contacts on faces come and go, or gain strength, while they are deep: a spring that stiffens while it
// is pressed gives back more than it got. So such a contact goes on with the force that there was. Its gap
// counts from a rest gap below 0, which rises to 0 slowly, or as fast as the contact lets go.

#include <span>
#include <vector>

#include "server/physics/contact/contact.h"

namespace prosector {

struct ContactMemory {
  bool soft = false;            // of the other side: a soft body, else a rigid one …
  std::size_t body = 0;         // … which
  std::uint32_t feature = 0;    // of the soft surface, as Contact::feature
  std::uint32_t met = 0;        // as Contact::met
  Vec3 grip = Vec3::Zero();     // as Contact::grip
  double force = 0;             // N, normal
  Vec3 normal = Vec3::UnitY();  // as Contact::normal
  double stiffness = 0;         // N/m
  double rest = 0;              // m, as Contact::rest
};

/// What the contacts of one soft body remember, in the order of (soft, body, feature, met).
using ContactMemories = std::vector<ContactMemory>;

/// Finds what a contact remembers; null: they did not press each other.
const ContactMemory* find(const ContactMemories& memories, const ContactSide& other, std::uint32_t feature,
                          std::uint32_t met = 0);

/// Finds, for layers, what this corner or edge held on that side, if on other parts of the other.
const ContactMemory* find_layer(const ContactMemories& memories, const Contact& contact);

/// Lets a contact of a point on the body's surface hold on where it did.
void recall(const ContactMemory* memory, Contact& contact);

/// Gives contacts on faces (those of features from `first_face` on) the rest gaps that keep the forces from
/// leaping. They must be all of the body's with that other side. h: s, the tick.
void rest(const ContactMemories& memories, std::uint32_t first_face, double h, std::span<Contact> contacts);

/// Returns whether all numbers are finite, force and stiffness are positive, and the rest gap is <= 0. keep()
/// stores no other memory, and a checkpoint is refused for one.
bool is_consistent(const ContactMemory& memory);

/// Takes what soft body `body` remembers of the tick.
void keep(std::span<const Contact> contacts, std::size_t body, ContactMemories& memories);

}  // namespace prosector
