#pragma once
// Where a finger meets a rigid body, friction acts over a patch.

#include <span>
#include <vector>

#include "server/physics/contact/colliders.h"
#include "server/physics/island.h"
#include "server/physics/state.h"

namespace prosector {

/// A finger's pad on a rigid body: a contact, and behind it those of its friction.
struct Pad {
  std::size_t island = 0, contact = 0;  // indices
  std::size_t hand = 0, body = 0;       // slots
  std::uint32_t part = 0;               // of the hand
  Vec3 place = Vec3::Zero();            // m, in its centre's frame
};

/// Puts contacts of the hand's segments, found in our own shapes, in place of those that Bullet found. Bullet
/// finds which pads touch what. But it tells how near they are in single precision, at one place of a line,
/// with boxes whose edges it rounds. Now and then for a tick it tells nothing at all: what fingers press
/// would shoot out between them. So the gap is looked up where a segment is nearest and at its ends, also for
/// pads that pressed in the last tick.
void place_pads(const Bodies& bodies, std::span<const Collider> colliders, const Hand& hand,
                std::vector<RigidContact>& touches);

/// Makes the friction of the last of the island's contacts, which is that of `touch`, act over a patch, and
/// lists the pad, if it is a finger's.
void spread_over_pad(const Bodies& bodies, std::span<const Hand> hands, const RigidContact& touch,
                     std::size_t island, std::vector<Contact>& contacts, std::vector<Pad>& pads);

/// Lets hands remember, after the islands are solved, where their pads press.
void keep_pads(const RigidWorld& world, std::span<const Island> islands, std::span<const Pad> pads,
               std::vector<Hand>& hands);

}  // namespace prosector
