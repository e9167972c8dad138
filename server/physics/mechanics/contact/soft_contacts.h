#pragma once
// Contacts of soft bodies in a tick, found before the tick is solved.

#include <cstddef>
#include <optional>
#include <vector>

#include "server/physics/mechanics/contact/contact.h"

namespace prosector::contact {

/// Contacts of two soft bodies a and b, or of one soft body with itself (a = b).
struct SoftPair {
  std::size_t a = 0, b = 0;  // a <= b
  std::vector<Contact> contacts;
};

struct SoftContacts {
  // By soft body:
  std::vector<std::vector<Contact>> with_rigid;    // with rigid bodies, hands and the room
  std::vector<std::size_t> group;                  // the lowest-numbered body of its connected group of pairs
  std::vector<int> passed_through;                 // number of elements that a thin shell has passed
  std::vector<std::optional<std::size_t>> parted;  // the body from which this one is being separated

  std::vector<SoftPair> pairs;  // those with contacts, ascending

  void resize(std::size_t soft_bodies) {
    with_rigid.resize(soft_bodies);
    passed_through.resize(soft_bodies, 0);
    parted.resize(soft_bodies);
  }
};

}  // namespace prosector::contact
