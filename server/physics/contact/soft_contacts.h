#pragma once
// What soft bodies touch in a tick, as found before it is solved.

#include <cstddef>
#include <optional>
#include <vector>

#include "server/physics/contact/contact.h"

namespace prosector {

/// Two soft bodies that touch, or one that touches itself.
struct SoftPair {
  std::size_t a = 0, b = 0;  // a <= b
  std::vector<Contact> contacts;
};

struct SoftContacts {
  // By soft body:
  std::vector<std::vector<Contact>> with_rigid;    // with rigid bodies, hands and the room
  std::vector<std::size_t> group;                  // the first body that pairs join it with
  std::vector<int> passed_through;                 // elements that a thin shell has passed
  std::vector<std::optional<std::size_t>> parted;  // another that it is led out of

  std::vector<SoftPair> pairs;  // ascending, those with contacts

  void resize(std::size_t soft_bodies) {
    with_rigid.resize(soft_bodies);
    passed_through.resize(soft_bodies, 0);
    parted.resize(soft_bodies);
  }
};

}  // namespace prosector
