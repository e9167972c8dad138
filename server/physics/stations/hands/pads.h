#pragma once
// Contacts of finger pads with rigid bodies, with friction that acts over a patch.

#include <span>
#include <vector>

#include "server/physics/mechanics/coupled/island.h"
#include "server/physics/stations/touching/colliders.h"
#include "server/physics/world/state.h"

namespace prosector {

/// A finger pad's contact with a rigid body. The contacts that distribute its friction over a patch directly
/// follow it in the list of contacts of its island (a set of bodies solved together).
struct Pad {
  std::size_t island = 0, contact = 0;  // indices
  std::size_t hand = 0, body = 0;       // slots
  std::uint32_t part = 0;               // index of the hand's part
  Vec3 place = Vec3::Zero();            // m, position in the frame of the hand's centre
};

/// Replaces the contacts that Bullet found for a hand's finger segments in `touches` by contacts with our own
/// shapes. Bullet determines which pads touch which bodies. But it computes gaps in single precision, at one
/// point of a line contact, and with boxes with rounded edges. Occasionally it reports no contact for a tick,
/// and a pinched body would be shot out of the fingers. So the gap is recomputed at the nearest point of a
/// segment and at its ends, also for pads that pressed in the last tick.
void place_pads(const Bodies& bodies, std::span<const contact::Collider> colliders, const hands::Hand& hand,
                std::vector<rigid::RigidContact>& touches);

/// Distributes the friction of the last entry of `contacts`, which was made from `touch`, over the points of
/// a patch if one of its bodies is a finger. In that case appends the finger pad to `pads`. `contacts` are
/// those of the island (a set of bodies solved together) with index `island`.
void spread_over_pad(const Bodies& bodies, std::span<const hands::Hand> hands,
                     const rigid::RigidContact& touch, std::size_t island,
                     std::vector<contact::Contact>& contacts, std::vector<Pad>& pads);

/// Stores the forces and friction of the finger pads' contacts in the hands after the islands (sets of bodies
/// solved together) were solved. The next tick starts from them.
void store_pads(const rigid::RigidWorld& world, std::span<const coupled::Island> islands,
                std::span<const Pad> pads, std::vector<hands::Hand>& hands);

}  // namespace prosector
