#include "server/physics/stations/hands/pads.h"

#include <algorithm>

#include "common/hand.h"
#include "server/physics/mechanics/contact/margins.h"
#include "server/physics/stations/hands/capsule_touch.h"

namespace prosector {
namespace {

constexpr double places_apart = 2e-3;  // m: least distance of a segment's contacts

/// The side of a contact that is a pad of a hand.
struct PadSide {
  bool is_b = false;
  std::uint32_t part = 0;
  std::size_t body = 0;  // the other side's slot
};

std::optional<PadSide> pad_of(const rigid::RigidContact& touch, std::size_t hand) {
  const bool is_b = touch.b == hand;
  const int part = is_b ? touch.part_b : touch.part_a;
  if ((!is_b && touch.a != hand) || part < 1 || part > static_cast<int>(hand_joints)) return std::nullopt;
  return PadSide{is_b, static_cast<std::uint32_t>(part), is_b ? touch.a : touch.b};
}

}  // namespace

void place_pads(const Bodies& bodies, std::span<const contact::Collider> colliders, const hands::Hand& hand,
                std::vector<rigid::RigidContact>& touches) {
  const std::size_t slot = hand.slot;
  const auto poses = hands::hand_part_poses(hand.side, hand.flexion, bodies.model.hands[hand.side].center);
  const Pose centre = bodies.rigid.motion(slot).pose;
  std::vector<rigid::RigidContact> found;  // one contact per pad and body
  const auto is_new = [&](std::uint32_t part, std::size_t body) {
    return std::none_of(found.begin(), found.end(), [&](const rigid::RigidContact& t) {
      return t.part_a == static_cast<int>(part) && t.b == body;
    });
  };
  const auto note_pad = [&](std::uint32_t part, std::size_t body, const Vec3& place, double friction) {
    if (!colliders[body].parts || !is_new(part, body)) return;
    rigid::RigidContact& pad = found.emplace_back();
    pad.a = slot;
    pad.b = body;
    pad.part_a = static_cast<int>(part);
    pad.part_b = -1;
    pad.point_a = place;
    pad.friction = friction;
  };
  std::erase_if(touches, [&](const rigid::RigidContact& touch) {
    const auto pad = pad_of(touch, slot);
    if (pad) note_pad(pad->part, pad->body, pad->is_b ? touch.point_b : touch.point_a, touch.friction);
    return pad.has_value();
  });
  for (const contact::PadMemory& memory : hand.pads)
    if (!hand.hold || hand.hold->body != memory.body)
      note_pad(memory.part, memory.body, centre * memory.place,
               bodies.model.scene.hand.friction * colliders[memory.body].friction);  // combined as in Bullet
  for (const rigid::RigidContact& pad : found) {
    const auto part = static_cast<std::size_t>(pad.part_a);
    const HandSegment& segment = hand_segments(hand.side)[part - 1];
    const Capsule capsule = {segment.length, segment.radius};
    const Pose pose = centre * poses[part];
    const double nearest =
        middle_along(capsule, pose, colliders[pad.b], pad.point_a, contact::contact_margin);
    for (const double along : {nearest, -segment.length / 2, segment.length / 2}) {
      if (along != nearest && std::abs(along - nearest) < places_apart) continue;
      rigid::RigidContact touch = touch_of(capsule, pose, colliders[pad.b], along, contact::contact_margin);
      if (!(touch.gap < contact::contact_margin)) continue;
      touch.a = pad.a;
      touch.b = pad.b;
      touch.part_a = pad.part_a;
      touch.part_b = pad.part_b;
      touch.friction = pad.friction;
      touches.push_back(touch);
    }
  }
}

void spread_over_pad(const Bodies& bodies, std::span<const hands::Hand> hands,
                     const rigid::RigidContact& touch, std::size_t island,
                     std::vector<contact::Contact>& contacts, std::vector<Pad>& pads) {
  const hands::Hand* hand =
      hands::hand_at(hands, touch.a) ? hands::hand_at(hands, touch.a) : hands::hand_at(hands, touch.b);
  const auto side = hand ? pad_of(touch, hand->slot) : std::nullopt;
  if (!side) return;
  const Pose centre = bodies.rigid.motion(hand->slot).pose;
  Pad& pad = pads.emplace_back();
  pad.island = island;
  pad.contact = contacts.size() - 1;
  pad.hand = hand->slot;
  pad.body = side->body;
  pad.part = side->part;
  pad.place = centre.inverse() * contacts.back().point;
  const contact::PadMemory* memory = contact::find(hand->pads, pad.part, pad.body, pad.place);
  const double radius =
      contact::contact_radius(hand_segments(hand->side)[pad.part - 1].radius, memory ? memory->force : 0);
  const auto poses = hands::hand_part_poses(hand->side, hand->flexion, bodies.model.hands[hand->side].center);
  const Vec3 along = centre.q * (poses[pad.part].q * Vec3::UnitY());
  contact::Contact share = contacts.back();
  share.rebound = 0;
  contacts.back().friction = 0;
  const auto points = contact::friction_points(share.normal, along, radius);
  for (std::uint32_t k = 0; k < contact::patch_points; ++k) {
    contact::Contact& c = contacts.emplace_back(share);
    c.bearer = k + 1;
    c.a.arm += points[k];
    c.b.arm += points[k];
    c.point += points[k];
    if (!memory) continue;
    c.grip = centre.q * memory->grip[k];
    c.gripped = memory->force / contact::patch_points;
  }
}

void store_pads(const rigid::RigidWorld& world, std::span<const coupled::Island> islands,
                std::span<const Pad> pads, std::vector<hands::Hand>& hands) {
  for (hands::Hand& hand : hands) hand.pads.clear();
  for (const Pad& pad : pads) {
    const auto& contacts = islands[pad.island].contacts;
    const double force = contacts[pad.contact].force;
    if (!(force > 0)) continue;
    const auto hand = std::find_if(hands.begin(), hands.end(),
                                   [&](const hands::Hand& other) { return other.slot == pad.hand; });
    contact::PadMemory memory;
    memory.part = pad.part;
    memory.body = pad.body;
    memory.place = pad.place;
    memory.force = force;
    for (std::size_t k = 0; k < contact::patch_points; ++k)
      memory.grip[k] = world.motion(pad.hand).pose.q.conjugate() * contacts[pad.contact + 1 + k].grip_after;
    hand->pads.push_back(memory);
  }
}

}  // namespace prosector
