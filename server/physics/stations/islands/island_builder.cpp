#include "server/physics/stations/islands/island_builder.h"

#include <algorithm>

#include "common/assert.h"
#include "server/physics/mechanics/contact/flat_elements.h"
#include "server/physics/mechanics/contact/rigid_contact_stiffness.h"
#include "server/physics/mechanics/coupled/restitution.h"
#include "server/physics/stations/hands/holding.h"

namespace prosector {
namespace {

constexpr double rigid_opening_speed = 0.25;  // m/s: largest separation speed of overlapping rigid bodies

Mat3 room_inertia(const rigid::RigidSetup& setup, const Pose& pose) {
  const Mat3 R = pose.q.toRotationMatrix();
  return R * setup.inertia.asDiagonal() * R.transpose();
}

contact::ContactSide rigid_side(const rigid::RigidWorld& world, std::size_t slot, const Vec3& point) {
  contact::ContactSide side;
  side.body = slot;
  if (const auto& to = world.driven_to(slot))
    side.moved = *to * (world.motion(slot).pose.inverse() * point) - point;
  if (!world.dynamic(slot)) return side;
  side.kind = contact::ContactSide::Kind::rigid;
  side.arm = point - world.motion(slot).pose.p;
  return side;
}

Vec3 velocity_of(const rigid::RigidWorld& world, const contact::ContactSide& side, std::size_t slot,
                 double h) {
  if (side.kind == contact::ContactSide::Kind::fixed) return side.moved / h;
  const rigid::RigidMotion motion = world.motion(slot);
  return motion.linear_velocity + motion.angular_velocity.cross(side.arm);
}

contact::Contact contact_of(const rigid::RigidWorld& world, const rigid::RigidContact& rc, double h) {
  contact::Contact c;
  c.a = rigid_side(world, rc.a, rc.point_a);
  c.b = rigid_side(world, rc.b, rc.point_b);
  c.point = (rc.point_a + rc.point_b) / 2;
  c.normal = rc.normal;
  c.gap = std::max(rc.gap, -rigid_opening_speed * h);
  c.friction = rc.friction;
  c.rebound = coupled::rebound_speed(
      rc.restitution, rc.normal.dot(velocity_of(world, c.a, rc.a, h) - velocity_of(world, c.b, rc.b, h)));
  return c;
}

bool between_soft(const contact::Contact& c) {
  return c.a.kind == contact::ContactSide::Kind::soft && c.b.kind == contact::ContactSide::Kind::soft &&
         c.a.body != c.b.body;
}

/// Links and couplings that the rigid world needs to find islands with soft bodies.
class Links {
 public:
  explicit Links(const contact::SoftContacts& touching)
      : touching_(touching), first_(touching.group.size()) {}
  void couple(std::size_t slot) { coupled.push_back(slot); }
  void join(std::size_t a, std::size_t b) { links.emplace_back(a, b); }
  void join_soft(std::size_t body, std::size_t slot) {
    std::optional<std::size_t>& known = first_[touching_.group[body]];
    if (known && *known != slot) links.emplace_back(*known, slot);
    if (!known) known = slot;
    coupled.push_back(slot);
  }
  std::vector<std::pair<std::size_t, std::size_t>> links;
  std::vector<std::size_t> coupled;

 private:
  const contact::SoftContacts& touching_;
  std::vector<std::optional<std::size_t>> first_;  // by soft group: a dynamic body of its island
};

void join_what_a_hand_touches(const hands::Hand& hand, const Bodies& bodies, Links& links) {
  links.couple(hand.slot);
  for (const contact::PadMemory& pad : hand.pads)
    if (bodies.rigid.dynamic(pad.body)) links.join(hand.slot, pad.body);
  if (!hand.hold) return;
  if (bodies.is_soft(hand.hold->body))
    links.join_soft(bodies.soft_index(hand.hold->body), hand.slot);
  else
    links.join(hand.slot, hand.hold->body);
}

}  // namespace

const std::vector<rigid::MixedIsland>& find_islands(Bodies& bodies, std::span<const hands::Hand> hands,
                                                    std::span<const rigid::RigidContact> reached,
                                                    const contact::SoftContacts& touching,
                                                    std::span<const organs::BladeGrip> grips, double h) {
  Links links(touching);
  for (std::size_t i = 0; i < bodies.soft.size(); ++i)
    for (const contact::Contact& c : touching.with_rigid[i])
      if (c.b.kind == contact::ContactSide::Kind::rigid) links.join_soft(i, c.b.body);
  for (const organs::BladeGrip& grip : grips) links.join_soft(grip.body, grip.slot);
  for (const hands::Hand& hand : hands) join_what_a_hand_touches(hand, bodies, links);
  for (const rigid::RigidContact& later : reached)
    if (bodies.rigid.dynamic(later.b)) links.join(later.a, later.b);
  bodies.rigid.find_islands(links.links, links.coupled);
  return bodies.rigid.solve(h);
}

IslandBuilder::IslandBuilder(Bodies& bodies, std::span<const hands::Hand> hands,
                             std::span<const rigid::RigidContact> reached,
                             const contact::SoftContacts& touching,
                             std::span<const contact::Collider> colliders,
                             std::span<const organs::BladeGrip> grips, double h)
    : bodies_(bodies),
      hands_(hands),
      reached_(reached),
      touching_(touching),
      colliders_(colliders),
      grips_(grips),
      h_(h),
      island_of_(bodies_.rigid.slots(), 0),
      island_of_group_(bodies_.soft.size()) {}

void IslandBuilder::build(std::span<const rigid::MixedIsland> mixed, std::vector<coupled::Island>& islands,
                          std::vector<Pad>& pads) {
  islands.clear();
  pads.clear();
  bodies_.retired.clear();
  for (const rigid::MixedIsland& m : mixed) {
    for (const std::size_t slot : m.bodies) island_of_[slot] = islands.size();
    coupled::Island& island = islands.emplace_back();
    add_rigid_members(m, island);
    add_rigid_contacts(m, islands.size() - 1, island, pads);
  }
  find_islands_of_groups();
  add_soft_members(islands);
  for (coupled::Island& island : islands) watch_flat_elements(island);
  for (coupled::Island& island : islands) set_stiffness(island);
  add_ties(islands);
}

void IslandBuilder::add_rigid_members(const rigid::MixedIsland& mixed, coupled::Island& island) {
  const Model& model = bodies_.model;
  for (const std::size_t slot : mixed.bodies) {
    const hands::Hand* hand = hands::hand_at(hands_, slot);
    const rigid::RigidSetup& setup = hand ? model.hands[hand->side].setup : model.rigid[slot].setup;
    const rigid::RigidMotion motion = bodies_.rigid.motion(slot);
    const Pose& pose = motion.pose;
    const auto [linear, angular] = bodies_.rigid.predicted_velocity(slot, h_);
    coupled::RigidMember member;
    member.slot = slot;
    member.mass = hand ? model.scene.hand.mass : setup.mass;
    member.inertia = room_inertia(setup, pose);
    member.predicted << h_ * linear, h_ * angular;
    member.steady << h_ * motion.linear_velocity, h_ * motion.angular_velocity;
    if (hand) member.pull = hands::hand_pull(*hand, model.hands[hand->side], model.scene.hand, pose, h_);
    island.rigid.push_back(member);
  }
}

void IslandBuilder::add_rigid_contacts(const rigid::MixedIsland& mixed, std::size_t index,
                                       coupled::Island& island, std::vector<Pad>& pads) const {
  std::vector<rigid::RigidContact> touches = mixed.contacts;
  for (const std::size_t slot : mixed.bodies)
    if (const hands::Hand* hand = hands::hand_at(hands_, slot))
      place_pads(bodies_, colliders_, *hand, touches);
  for (const rigid::RigidContact& later : reached_)
    if (std::binary_search(mixed.bodies.begin(), mixed.bodies.end(), later.a)) touches.push_back(later);
  for (const rigid::RigidContact& rc : touches) {
    island.contacts.push_back(contact_of(bodies_.rigid, rc, h_));
    spread_over_pad(bodies_, hands_, rc, index, island.contacts, pads);
  }
}

/// Finds the island of each group of soft bodies: that of a rigid body that touches or holds one of them.
/// add_soft_members() creates islands for the other groups.
void IslandBuilder::find_islands_of_groups() {
  const std::vector<std::size_t>& group = touching_.group;
  for (std::size_t i = 0; i < bodies_.soft.size(); ++i)
    for (const contact::Contact& c : touching_.with_rigid[i])
      if (c.b.kind == contact::ContactSide::Kind::rigid) island_of_group_[group[i]] = island_of_[c.b.body];
  for (const organs::BladeGrip& grip : grips_) island_of_group_[group[grip.body]] = island_of_[grip.slot];
  for (const hands::Hand& hand : hands_)
    if (hand.hold && bodies_.is_soft(hand.hold->body))
      island_of_group_[group[bodies_.soft_index(hand.hold->body)]] = island_of_[hand.slot];
}

void IslandBuilder::add_soft_members(std::vector<coupled::Island>& islands) {
  for (Tissue& tissue : bodies_.soft) {
    if (tissue.state.asleep) continue;
    std::optional<std::size_t>& at = island_of_group_[touching_.group[tissue.index]];
    if (!at) {
      at = islands.size();
      islands.emplace_back();
    }
    PROSECTOR_ASSERT(*at < islands.size());
    coupled::Island& island = islands[*at];
    island.soft.push_back({tissue.index, tissue.solver.get(), &tissue.state, &tissue.equilibrium});
    const std::vector<contact::Contact>& contacts = touching_.with_rigid[tissue.index];
    island.contacts.insert(island.contacts.end(), contacts.begin(), contacts.end());
  }
  for (const contact::SoftPair& pair : touching_.pairs) {
    coupled::Island& island = islands[*island_of_group_[touching_.group[pair.a]]];
    island.contacts.insert(island.contacts.end(), pair.contacts.begin(), pair.contacts.end());
  }
}

/// Adds contacts that keep elements of solids in contact with other soft bodies from inverting.
void IslandBuilder::watch_flat_elements(coupled::Island& island) const {
  const std::size_t met = island.contacts.size();
  for (const coupled::SoftMember& s : island.soft) {
    if (std::none_of(island.contacts.begin(), island.contacts.begin() + static_cast<std::ptrdiff_t>(met),
                     [&](const contact::Contact& c) {
                       return between_soft(c) && (c.a.body == s.index || c.b.body == s.index);
                     }))
      continue;
    const double stiffness = bodies_.model.scene.contact_stiffness * s.body->desc().material.youngs_modulus;
    contact::find_flat_elements(s.body->linear_tets(), s.state->motion.x, s.state->motion.v,
                                {s.index, stiffness, h_}, island.contacts);
  }
}

/// Sets the stiffness of contacts between rigid bodies, and whether something kinematic keeps the island
/// awake.
void IslandBuilder::set_stiffness(coupled::Island& island) const {
  const auto driven = [&](const contact::ContactSide& side) {
    return side.kind == contact::ContactSide::Kind::fixed && bodies_.rigid.driven_to(side.body);
  };
  island.driven = std::any_of(island.contacts.begin(), island.contacts.end(),
                              [&](const contact::Contact& c) { return driven(c.a) || driven(c.b); });
  double heaviest = 0;
  for (const coupled::RigidMember& r : island.rigid) heaviest = std::max(heaviest, r.mass);
  for (const coupled::SoftMember& s : island.soft) heaviest = std::max(heaviest, s.body->total_mass());
  for (contact::Contact& c : island.contacts)
    if (c.a.kind != contact::ContactSide::Kind::soft && c.bearer == 0)
      c.stiffness = contact::rigid_contact_stiffness(heaviest, h_);
}

/// Adds the ties of blades in tissue first, then those of holds.
void IslandBuilder::add_ties(std::vector<coupled::Island>& islands) const {
  for (const organs::BladeGrip& grip : grips_) islands[island_of_[grip.slot]].ties.push_back(grip.tie);
  for (const hands::Hand& hand : hands_) {
    if (!hand.hold) continue;
    coupled::Island& island = islands[island_of_[hand.slot]];
    const std::vector<HeldPoint> points = held_points(bodies_, hand);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const HeldPoint& p = points[i];
      contact::Tie tie;
      if (bodies_.is_soft(hand.hold->body))
        tie.b = bodies_.soft[bodies_.soft_index(hand.hold->body)].side(hand.hold->points[i].vertex);
      else
        tie.b = rigid_side(bodies_.rigid, hand.hold->body, p.at_body);
      tie.a = rigid_side(bodies_.rigid, hand.slot, p.at_hand);
      tie.offset = p.at_hand - p.at_body;
      tie.stiffness = p.stiffness;
      tie.max_force = p.max_force;
      island.ties.push_back(tie);
    }
  }
}

}  // namespace prosector
