#include "server/physics/hands/touching.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "server/physics/contact/rigid_soft_contacts.h"

namespace prosector {
namespace {

const Hand* hand_of(const State& state, const HandRef& ref) {
  for (const Hand& hand : state.hands)
    if (hand.participant == ref.participant && hand.side == ref.hand) return &hand;
  return nullptr;
}

/// Returns whose slot of the rigid world it is; nothing: no hand's.
std::optional<HandRef> owner_of(const State& state, std::size_t slot) {
  const Hand* hand = hand_at(state.hands, slot);
  if (hand == nullptr) return std::nullopt;
  return HandRef{hand->participant, static_cast<std::uint8_t>(hand->side)};
}

BodyId body_of(const State& state, const ContactSide& side) {
  return side.kind == ContactSide::Kind::soft ? state.bodies.soft_id(side.body)
                                              : static_cast<BodyId>(side.body);
}

/// Returns the touch of a contact whose side `on_hand` is the hand's.
HandTouch touch_of(const State& state, const Contact& c, bool hand_is_b) {
  const ContactSide& met = hand_is_b ? c.a : c.b;
  HandTouch out;
  out.body = body_of(state, met);
  out.side = met;
  out.normal = hand_is_b ? Vec3(-c.normal) : c.normal;
  const ContactSide& own = hand_is_b ? c.b : c.a;
  const RigidMotion motion = state.bodies.rigid.motion(own.body);
  out.point = motion.pose.p + own.arm;
  out.gap = c.gap + c.rest;
  out.force = c.force;
  out.exchanged = hand_is_b ? Vec3(-c.exchanged) : c.exchanged;
  out.stiffness = c.stiffness;
  out.friction = c.friction;
  return out;
}

/// Adds the nearest point of each soft body that is near the hand and doesn't press on it.
void add_near_tissue(const State& state, const Collider& collider, const Hand& hand, double reach,
                     std::vector<HandTouch>& out) {
  for (const Tissue& tissue : state.bodies.soft) {
    const BodyId body = state.bodies.soft_id(tissue.index);
    const auto same = [&](const HandTouch& t) { return t.body == body; };
    if (state.bodies.parts[body].out_of_touch() || !may_meet(tissue, collider) ||
        std::any_of(out.begin(), out.end(), same) || (hand.hold && hand.hold->body == body))
      continue;
    std::optional<HandTouch> nearest;
    tissue.surface.vertices().near(collider, reach, [&](std::uint32_t vertex, const Distance& d) {
      if (nearest && nearest->gap <= d.value) return;
      nearest.emplace();
      nearest->body = body;
      nearest->side = tissue.side(vertex);
      nearest->normal = -d.normal;
      nearest->point = tissue.surface.vertices().positions()[vertex] - d.value * d.normal;
      nearest->gap = d.value;
      nearest->stiffness = tissue.contact_stiffness(vertex);
      nearest->friction = std::sqrt(tissue.desc().friction * collider.friction);
    });
    if (nearest) out.push_back(*nearest);
  }
}

std::vector<HandTouch> touches_of(const State& state, std::span<const Island> islands,
                                  std::span<const Collider> colliders, const Hand& hand, double reach) {
  std::vector<HandTouch> out;
  const auto own = [&](const ContactSide& side) {
    return side.kind == ContactSide::Kind::rigid && side.body == hand.slot;
  };
  for (const Island& island : islands)
    for (const Contact& c : island.contacts)
      if (c.force > 0 && c.bearer == 0 && own(c.a) != own(c.b)) out.push_back(touch_of(state, c, own(c.b)));
  if (hand.slot < colliders.size()) add_near_tissue(state, colliders[hand.slot], hand, reach, out);
  return out;
}

/// Adds what presses on a soft body in the tick's islands, or holds it.
void add_supports(const State& state, std::span<const Island> islands, BodyId body,
                  std::vector<Support>& out) {
  const std::size_t index = state.bodies.soft_index(body);
  const auto own = [&](const ContactSide& side) {
    return side.kind == ContactSide::Kind::soft && side.body == index;
  };
  const auto add = [&](const ContactSide& side, const ContactSide& other, const Mat3& stiffness) {
    std::optional<HandRef> hand;
    if (other.kind == ContactSide::Kind::rigid) hand = owner_of(state, other.body);
    out.push_back({body, side, stiffness, hand});
  };
  for (const Island& island : islands) {
    for (const Contact& c : island.contacts) {
      if (!(c.force > 0) || own(c.a) == own(c.b)) continue;
      const bool is_a = own(c.a);
      add(is_a ? c.a : c.b, is_a ? c.b : c.a, c.stiffness * c.normal * c.normal.transpose());
    }
    for (const Tie& tie : island.ties)
      if (own(tie.a) != own(tie.b))
        add(own(tie.a) ? tie.a : tie.b, own(tie.a) ? tie.b : tie.a, tie.stiffness * Mat3::Identity());
  }
}

}  // namespace

HandSurroundings surroundings_of(const State& state, std::span<const Island> islands,
                                 std::span<const Collider> colliders, const HandRef& ref, double reach) {
  HandSurroundings out;
  const Hand* hand = hand_of(state, ref);
  if (hand == nullptr) return out;
  out.touches = touches_of(state, islands, colliders, *hand, reach);
  std::set<BodyId> met;
  for (const HandTouch& touch : out.touches)
    if (state.bodies.is_soft(touch.body)) met.insert(touch.body);
  for (const BodyId body : met) add_supports(state, islands, body, out.supports);
  return out;
}

}  // namespace prosector
