#include "server/physics/stations/touching/soft_contact_finder.h"

#include <algorithm>
#include <numeric>

#include "server/physics/base/parallel.h"
#include "server/physics/mechanics/contact/margins.h"
#include "server/physics/stations/touching/parting_contacts.h"
#include "server/physics/stations/touching/proxy_contacts.h"
#include "server/physics/stations/touching/rigid_soft_contacts.h"
#include "server/physics/stations/touching/soft_pair_contacts.h"
#include "server/physics/stations/touching/swept_contacts.h"
#include "server/physics/stations/touching/thin_shell_contacts.h"

namespace prosector {
namespace {

constexpr double still_margin = 0.005;  // m: motion of a soft body before its position in the tree is updated

collision::BroadPhase::Id box_id(std::size_t body) {
  return static_cast<collision::BroadPhase::Id>(body);
}

/// Returns a box around the body's positions within the next h s.
collision::Aabb box_of(const Tissue& tissue, double h) {
  const double reach = tissue.state.asleep ? 0 : std::min(contact::most_reach, tissue.reach(h));
  return tissue.outer_box().grown(contact::wake_margin + reach);
}

bool is_awake(const contact::Collider& c, const rigid::RigidWorld& world) {
  return c.driven_to || (!c.fixed && !world.motion(c.slot).asleep);
}

/// Returns whether a moving collider is about to touch a sleeping body.
bool woken_by_rigid(const Tissue& tissue, std::span<const contact::Collider> colliders,
                    const rigid::RigidWorld& world, double h) {
  return std::any_of(colliders.begin(), colliders.end(), [&](const contact::Collider& c) {
    if (!may_meet(tissue, c) || !is_awake(c, world)) return false;
    std::vector<contact::Contact> found;
    return touches(tissue, c, contact::wake_margin + std::min(contact::most_reach, h * total_speed(c))) ||
           (is_swept(tissue, c, h) && add_swept_contacts(tissue, c, contact::contact_margin, h, found));
  });
}

/// Appends the body's contacts with one collider. `own`: bound of the body's motion in the tick, m.
void add_rigid_contacts(const Tissue& tissue, const contact::Collider& c, double own, double h,
                        std::vector<contact::Contact>& out) {
  const double reach = rigid::is_room(c.slot)
                           ? own
                           : std::min(contact::most_reach, own + std::max(c.pull, h * total_speed(c)));
  if (is_swept(tissue, c, h))
    add_swept_contacts(tissue, c, contact::contact_margin + reach, h, out);
  else
    add_contacts(tissue, c, contact::contact_margin + reach, tissue.memories, h, out);
}

/// Removes the sides of pairs that are no longer near; pairs with a sleeping body keep theirs.
void forget_sides(LayerSides& sides, const Bodies& bodies,
                  std::span<const collision::BroadPhase::Pair> near) {
  std::erase_if(sides, [&](const auto& entry) {
    const auto [a, b] = entry.first;
    if (bodies.soft[a].state.asleep || bodies.soft[b].state.asleep || a == b) return false;
    return !std::binary_search(near.begin(), near.end(), collision::BroadPhase::Pair(box_id(a), box_id(b)));
  });
}

}  // namespace

SoftContactFinder::SoftContactFinder(std::size_t soft_bodies) : boxes_(still_margin) {
  found_.resize(soft_bodies);
}

const contact::SoftContacts& SoftContactFinder::find(State& state,
                                                     std::span<const contact::Collider> colliders, double h) {
  found_.resize(state.bodies.soft.size());
  for (auto& list : found_.with_rigid) list.clear();
  for (Tissue& tissue : state.bodies.soft) tissue.begin_tick();
  track(state.bodies, h);
  meet_rigid(state, colliders, h);
  meet_each_other(state, h);
  return found_;
}

/// Updates the boxes to the bodies' positions within the next h s.
void SoftContactFinder::track(const Bodies& bodies, double h) {
  for (std::size_t gone = bodies.soft.size(); gone < tracked_; ++gone)
    if (boxes_.has(box_id(gone))) boxes_.remove(box_id(gone));
  tracked_ = bodies.soft.size();
  for (const Tissue& tissue : bodies.soft) {
    if (tissue.collision.fidelity == Fidelity::none) continue;
    const collision::BroadPhase::Id id = box_id(tissue.index);
    const bool moves = !tissue.state.asleep;
    if (!boxes_.has(id)) {
      boxes_.add(id, box_of(tissue, h), tissue.collision.mask, moves);
      continue;
    }
    boxes_.set_moves(id, moves);
    boxes_.update(id, box_of(tissue, h));
  }
}

void SoftContactFinder::meet_rigid(State& state, std::span<const contact::Collider> colliders, double h) {
  Bodies& bodies = state.bodies;
  std::vector<char> done(bodies.soft.size(), 0);
  for (bool again = true; again;) {
    again = false;
    for (std::size_t i = 0; i < bodies.soft.size(); ++i) {
      Tissue& tissue = bodies.soft[i];
      if (done[i] || bodies.parts[bodies.soft_id(i)].out_of_touch()) continue;
      if (tissue.state.asleep) {
        if (!woken_by_rigid(tissue, colliders, bodies.rigid, h) && !woken_by_soft(state, i, h)) continue;
        tissue.wake();
      }
      done[i] = 1;
      again = true;
      tissue.place_surface();
      list_rigid(bodies, tissue, colliders, h);
    }
  }
}

/// Lists the body's contacts with colliders, and wakes these.
void SoftContactFinder::list_rigid(Bodies& bodies, Tissue& tissue,
                                   std::span<const contact::Collider> colliders, double h) {
  const double own = tissue.reach(h);
  by_collider_.resize(colliders.size());
  parallel_each(colliders.size(), [&](std::size_t i) {
    by_collider_[i].clear();
    if (may_meet(tissue, colliders[i])) add_rigid_contacts(tissue, colliders[i], own, h, by_collider_[i]);
  });
  std::vector<contact::Contact>& out = found_.with_rigid[tissue.index];
  for (std::size_t i = 0; i < colliders.size(); ++i) {
    if (by_collider_[i].empty()) continue;
    out.insert(out.end(), by_collider_[i].begin(), by_collider_[i].end());
    const contact::Collider& c = colliders[i];
    if (!c.fixed && bodies.rigid.motion(c.slot).asleep) bodies.rigid.wake(c.slot);
  }
}

bool SoftContactFinder::woken_by_soft(State& state, std::size_t body, double h) {
  const Bodies& bodies = state.bodies;
  if (bodies.soft[body].collision.fidelity == Fidelity::none) return false;
  std::vector<contact::Contact> found;
  for (const std::size_t other : boxes_.query(box_of(bodies.soft[body], h)))
    if (!bodies.soft[other].state.asleep && bodies.may_meet(body, other) &&
        add_pair_contacts(state, body, other,
                          contact::wake_margin + std::min(contact::most_reach, bodies.soft[other].reach(h)),
                          h, found))
      return true;
  return false;
}

void SoftContactFinder::meet_each_other(State& state, double h) {
  const std::deque<Tissue>& soft = state.bodies.soft;
  for (const Tissue& tissue : soft)  // bodies that woke in this tick
    if (boxes_.has(box_id(tissue.index))) boxes_.set_moves(box_id(tissue.index), !tissue.state.asleep);
  // Clears marks from the contact queries for waking.
  std::fill(found_.parted.begin(), found_.parted.end(), std::nullopt);
  still_entangled_.clear();
  std::fill(found_.passed_through.begin(), found_.passed_through.end(), 0);
  std::vector<collision::BroadPhase::Pair> near = boxes_.find_pairs();
  for (collision::BroadPhase::Id i = 0; i < soft.size(); ++i)
    if (soft[i].collision.with_itself) near.emplace_back(i, i);
  std::sort(near.begin(), near.end());
  std::size_t used = 0;
  for (const auto& [a, b] : near) {
    if (soft[a].state.asleep || soft[b].state.asleep || !state.bodies.may_meet(a, b)) continue;
    if (used == found_.pairs.size()) found_.pairs.emplace_back();
    contact::SoftPair& pair = found_.pairs[used];
    pair.a = a;
    pair.b = b;
    pair.contacts.clear();
    // When a solid hits something, one part stops while the other moves on.
    const double nearing =
        a == b && soft[a].is_thin() ? soft[a].inner_reach(h) : soft[a].reach(h) + soft[b].reach(h);
    const double reach = std::min(contact::most_reach, nearing);
    if (add_pair_contacts(state, a, b, contact::contact_margin + reach, h, pair.contacts)) ++used;
  }
  found_.pairs.resize(used);
  std::swap(state.entangled, still_entangled_);
  forget_sides(state.layer_sides, state.bodies, near);
  group(soft.size());
}

bool SoftContactFinder::add_pair_contacts(State& state, std::size_t a, std::size_t b, double margin, double h,
                                          std::vector<contact::Contact>& out) {
  Tissue &first = state.bodies.soft[a], &second = state.bodies.soft[b];
  const std::size_t before = out.size();
  if (a == b && !first.is_thin()) {
    add_self_contacts(first, margin, h, meetings_, out);
    return out.size() > before;
  }
  if (a != b && !first.outer_box().grown(margin).overlaps(second.outer_box())) return false;
  if (first.surface.proxy() || second.surface.proxy())
    return add_proxy_pair_contacts(first, second, margin, out);
  if (first.surface.thin_shell() && second.surface.thin_shell())
    return add_thin_contacts(state, std::min(a, b), std::max(a, b), margin, h, out);
  const bool deep = add_vertex_contacts(first, second, margin, meetings_, out);
  if (deep || state.entangled.contains({a, b})) lead_apart(state, first, second, h, before, out);
  return out.size() > before;
}

bool SoftContactFinder::add_thin_contacts(State& state, std::size_t a, std::size_t b, double margin, double h,
                                          std::vector<contact::Contact>& out) {
  const auto both_in = [&](const auto& organ) {
    return organ.second.grouping().has(a) && organ.second.grouping().has(b);
  };
  const auto& organs = state.dissection.organs;
  const bool one_organ = a == b || std::any_of(organs.begin(), organs.end(), both_in);
  const std::size_t before = out.size();
  std::vector<contact::LayerSide>& sides = state.layer_sides[{a, b}];
  const int passed =
      add_thin_shell_contacts(state.bodies.soft[a], state.bodies.soft[b], sides, one_organ, margin, h, out);
  found_.passed_through[a] += passed;
  if (a != b) found_.passed_through[b] += passed;
  if (sides.empty()) state.layer_sides.erase({a, b});
  return out.size() > before;
}

void SoftContactFinder::lead_apart(State& state, Tissue& a, Tissue& b, double h, std::size_t first,
                                   std::vector<contact::Contact>& out) {
  const auto pressed = [&](const Tissue& tissue) {
    return hands::in_a_hand(state.hands, state.bodies.soft_id(tissue.index), found_.with_rigid[tissue.index]);
  };
  const auto known = state.entangled.find({a.index, b.index});
  const auto now = add_parting_contacts(a, b, known != state.entangled.end() ? &known->second : nullptr,
                                        pressed(a) || pressed(b), h, first, out);
  if (!now) return;
  still_entangled_[{a.index, b.index}] = *now;
  found_.parted[a.index] = b.index;
  found_.parted[b.index] = a.index;
}

/// Finds each body's group: the lowest-numbered body connected with it by pairs.
void SoftContactFinder::group(std::size_t soft_bodies) {
  std::vector<std::size_t>& group = found_.group;
  group.resize(soft_bodies);
  std::iota(group.begin(), group.end(), std::size_t{0});
  const auto first = [&](std::size_t body) {
    while (group[body] != body) body = group[body] = group[group[body]];
    return body;
  };
  for (const contact::SoftPair& pair : found_.pairs) {
    const std::size_t a = first(pair.a), b = first(pair.b);
    group[std::max(a, b)] = std::min(a, b);
  }
  for (std::size_t i = 0; i < soft_bodies; ++i) group[i] = first(i);
}

}  // namespace prosector
