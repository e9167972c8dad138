#include "server/physics/stations/hands/touching.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "server/physics/stations/hands/holding.h"
#include "server/physics/stations/touching/rigid_soft_contacts.h"

namespace prosector {
namespace {

const hands::Hand* hand_of(const State& state, const HandRef& ref) {
  for (const hands::Hand& hand : state.hands)
    if (hand.participant == ref.participant && hand.side == ref.hand) return &hand;
  return nullptr;
}

/// Returns whether the hand holds the rigid body in that slot, which then counts as part of the hand.
bool wields(const State& state, const hands::Hand& hand, std::size_t slot) {
  return hand.hold && !state.bodies.is_soft(hand.hold->body) && hand.hold->body == slot;
}

/// Returns whether a contact's side is the hand, or a rigid body that it holds.
bool is_of(const State& state, const hands::Hand& hand, const contact::ContactSide& side) {
  return side.kind == contact::ContactSide::Kind::rigid &&
         (side.body == hand.slot || wields(state, hand, side.body));
}

/// Returns the hand with this slot, or that holds the body in this slot; none: no hand.
std::optional<HandRef> owner_of(const State& state, std::size_t slot) {
  for (const hands::Hand& hand : state.hands)
    if (hand.slot == slot || wields(state, hand, slot))
      return HandRef{hand.participant, static_cast<std::uint8_t>(hand.side)};
  return std::nullopt;
}

BodyId body_of(const State& state, const contact::ContactSide& side) {
  return side.kind == contact::ContactSide::Kind::soft ? state.bodies.soft_id(side.body)
                                                       : static_cast<BodyId>(side.body);
}

/// Returns the compliance of a point of the hand, or of its held body, in `slot`, m/N.
Mat3 give_of(const State& state, const hands::Hand& hand, std::size_t slot, const Vec3& point) {
  const Mat3 coupling = hands::coupling_give(state.bodies.rigid.motion(hand.slot).pose, point);
  return slot == hand.slot ? coupling : Mat3(coupling + grip_give(state.bodies, hand, point));
}

/// Returns the touch for a contact or tie between the hand's side and another side, without its force.
HandTouch touch_between(const State& state, const hands::Hand& hand, const contact::ContactSide& own,
                        const contact::ContactSide& met) {
  HandTouch out;
  out.body = body_of(state, met);
  out.side = met;
  out.point = state.bodies.rigid.motion(own.body).pose.p + own.arm;
  out.give = give_of(state, hand, own.body, out.point);
  return out;
}

HandTouch touch_of(const State& state, const hands::Hand& hand, const contact::Contact& c) {
  const bool hand_is_b = is_of(state, hand, c.b);
  HandTouch out = touch_between(state, hand, hand_is_b ? c.b : c.a, hand_is_b ? c.a : c.b);
  out.normal = hand_is_b ? Vec3(-c.normal) : c.normal;
  out.gap = c.gap + c.rest;
  out.force = c.force;
  out.exchanged = hand_is_b ? Vec3(-c.exchanged) : c.exchanged;
  out.stiffness = c.stiffness;
  out.friction = c.friction;
  return out;
}

/// Returns the touch for a tie of the hand, or of a blade in the hand. At its force limit a tie stretches
/// freely.
HandTouch touch_of(const State& state, const hands::Hand& hand, const contact::Tie& tie) {
  const bool hand_is_b = is_of(state, hand, tie.b);
  HandTouch out = touch_between(state, hand, hand_is_b ? tie.b : tie.a, hand_is_b ? tie.a : tie.b);
  out.exchanged = hand_is_b ? Vec3(-tie.force) : tie.force;
  out.force = tie.force.norm();
  out.stiffness = tie.stiffness;
  out.holds = true;
  out.bound = tie.max_force;
  return out;
}

/// Returns the weight of the rigid body that the hand holds.
HandTouch weight_of(const State& state, const hands::Hand& hand) {
  const Bodies& bodies = state.bodies;
  const rigid::RigidSetup& setup = bodies.model.rigid[hand.hold->body].setup;
  HandTouch out;
  out.body = hand.hold->body;
  out.side.kind = contact::ContactSide::Kind::rigid;
  out.side.body = hand.hold->body;
  out.point = bodies.rigid.motion(hand.hold->body).pose.p;
  out.exchanged = setup.balanced ? Vec3(Vec3::Zero()) : Vec3(setup.mass * bodies.model.scene.gravity);
  out.force = out.bound = out.exchanged.norm();
  out.holds = true;
  return out;
}

/// Adds the nearest point of each soft body that is near the hand, or its held body, and does not press it.
void add_near_tissue(const State& state, const contact::Collider& collider, const hands::Hand& hand,
                     std::size_t slot, double reach, std::vector<HandTouch>& out) {
  for (const Tissue& tissue : state.bodies.soft) {
    const BodyId body = state.bodies.soft_id(tissue.index);
    const auto same = [&](const HandTouch& t) { return t.body == body; };
    if (state.bodies.parts[body].out_of_touch() || !may_meet(tissue, collider) ||
        std::any_of(out.begin(), out.end(), same) || (hand.hold && hand.hold->body == body))
      continue;
    std::optional<HandTouch> nearest;
    tissue.surface.vertices().near(collider, reach, [&](std::uint32_t vertex, const contact::Distance& d) {
      if (nearest && nearest->gap <= d.value) return;
      nearest.emplace();
      nearest->body = body;
      nearest->side = tissue.side(vertex);
      nearest->normal = -d.normal;
      nearest->point = tissue.surface.vertices().positions()[vertex] - d.value * d.normal;
      nearest->gap = d.value;
      nearest->stiffness = tissue.contact_stiffness(vertex);
      nearest->friction = std::sqrt(tissue.desc().contact.friction * collider.friction);
    });
    if (!nearest) continue;
    nearest->give = give_of(state, hand, slot, nearest->point);
    out.push_back(*nearest);
  }
}

/// Adds the contacts and ties of the hand, or of its held body, in the tick's islands. Soft contacts count if
/// they press; rigid contacts always.
void add_met(const State& state, std::span<const coupled::Island> islands, const hands::Hand& hand,
             std::vector<HandTouch>& out) {
  const auto between = [&](const auto& joint) {
    return is_of(state, hand, joint.a) != is_of(state, hand, joint.b);
  };
  for (const coupled::Island& island : islands) {
    for (const contact::Contact& c : island.contacts) {
      const bool rigid =
          c.a.kind != contact::ContactSide::Kind::soft && c.b.kind != contact::ContactSide::Kind::soft;
      if (!between(c) || !(c.force > 0 || rigid)) continue;
      HandTouch touch = touch_of(state, hand, c);
      if (c.bearer > 0)
        touch.force = touch.stiffness = 0;  // a pad's friction; its normal contact is reported separately
      out.push_back(touch);
    }
    for (const contact::Tie& tie : island.ties)
      if (between(tie)) out.push_back(touch_of(state, hand, tie));
  }
}

std::vector<HandTouch> touches_of(const State& state, std::span<const coupled::Island> islands,
                                  std::span<const contact::Collider> colliders, const hands::Hand& hand,
                                  double reach) {
  std::vector<HandTouch> out;
  add_met(state, islands, hand, out);
  const auto add_near = [&](std::size_t slot) {
    if (slot < colliders.size()) add_near_tissue(state, colliders[slot], hand, slot, reach, out);
  };
  add_near(hand.slot);
  if (hand.hold && wields(state, hand, hand.hold->body)) {
    if (state.bodies.model.blades[hand.hold->body].edges.empty()) add_near(hand.hold->body);
    const HandTouch weight = weight_of(state, hand);
    if (weight.force > 0) out.push_back(weight);
  }
  return out;
}

/// Adds the contacts that press the soft body, and its ties, in the tick's islands.
void add_supports(const State& state, std::span<const coupled::Island> islands, BodyId body,
                  std::vector<Support>& out) {
  const std::size_t index = state.bodies.soft_index(body);
  const auto own = [&](const contact::ContactSide& side) {
    return side.kind == contact::ContactSide::Kind::soft && side.body == index;
  };
  const auto add = [&](const contact::ContactSide& side, const contact::ContactSide& other,
                       const Mat3& stiffness) {
    std::optional<HandRef> hand;
    if (other.kind == contact::ContactSide::Kind::rigid) hand = owner_of(state, other.body);
    out.push_back({body, side, stiffness, hand});
  };
  for (const coupled::Island& island : islands) {
    for (const contact::Contact& c : island.contacts) {
      if (!(c.force > 0) || own(c.a) == own(c.b)) continue;
      const bool is_a = own(c.a);
      add(is_a ? c.a : c.b, is_a ? c.b : c.a, c.stiffness * c.normal * c.normal.transpose());
    }
    for (const contact::Tie& tie : island.ties)
      if (own(tie.a) != own(tie.b))
        add(own(tie.a) ? tie.a : tie.b, own(tie.a) ? tie.b : tie.a, tie.stiffness * Mat3::Identity());
  }
}

}  // namespace

HandSurroundings surroundings_of(const State& state, std::span<const coupled::Island> islands,
                                 std::span<const contact::Collider> colliders, const HandRef& ref,
                                 double reach) {
  HandSurroundings out;
  const hands::Hand* hand = hand_of(state, ref);
  if (hand == nullptr) return out;
  out.touches = touches_of(state, islands, colliders, *hand, reach);
  std::set<BodyId> met;
  for (const HandTouch& touch : out.touches)
    if (state.bodies.is_soft(touch.body)) met.insert(touch.body);
  for (const BodyId body : met) add_supports(state, islands, body, out.supports);
  return out;
}

}  // namespace prosector
