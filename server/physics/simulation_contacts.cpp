// Phase 3: which soft surfaces touch which rigid bodies, and who wakes whom by it.

#include <algorithm>

#include "server/physics/simulation_impl.h"

namespace prosector {
namespace {

// Stretch of the surface at which a moving thing loses hold of it: real tissue would have torn long before,
// and what a leaping hand has hooked would never come free.
constexpr double most_stretch = 3;

}  // namespace

void Simulation::Impl::refresh_colliders() {
  colliders.assign(world.slots(), {});
  for (std::size_t slot = 0; slot < world.slots(); ++slot) {
    if (!world.used(slot) || world.presence(slot) == BodyPresence::absent) continue;
    Collider& c = colliders[slot];
    const RigidMotion motion = world.motion(slot);
    const Hand* hand = hand_at(slot);
    const RigidShape& shape = hand ? model.hands[hand->side].shape : model.rigid[slot].shape;
    c.slot = slot;
    c.pose = motion.pose;
    c.linear = motion.linear_velocity;
    c.angular = motion.angular_velocity;
    c.parts = &shape.parts;
    c.distances = &shape.distances;
    if (hand)
      c.part_poses = hand_part_poses(hand->side, hand->flexion, model.hands[hand->side].center);
    else
      for (const ShapePart& part : shape.parts) c.part_poses.push_back(part.pose);
    std::tie(c.lo, c.hi) = world.bounds(slot, 0);
    c.friction = body_friction(slot);
    c.fixed = !world.dynamic(slot);
    if (hand)
      c.pull = std::min(most_reach, ((hand->target * model.hands[hand->side].center).p - c.pose.p).norm());
  }
}

double Simulation::Impl::body_friction(std::size_t slot) const {
  return hand_at(slot) ? model.scene.hand.friction : model.rigid[slot].setup.friction;
}
double Simulation::Impl::body_mass(std::size_t slot) const {
  return hand_at(slot) ? model.scene.hand.mass : model.rigid[slot].setup.mass;
}
double Simulation::Impl::total_speed(const Collider& c) const {
  return c.linear.norm() + c.angular.norm() * (c.hi - c.lo).norm() / 2;
}

ContactSide Simulation::Impl::surface_side(std::size_t body, std::uint32_t vertex) const {
  ContactSide side;
  side.kind = ContactSide::Kind::soft;
  side.body = body;
  side.add(model.soft[body]->anatomy().embedding.rows[vertex], 1);
  return side;
}

// A sheet's surface is the one through its middle, a rope's is its axis: what touches them stops short of it.
double Simulation::Impl::skin_of(std::size_t body) const {
  return model.soft[body]->anatomy().thickness / 2;
}

Contact Simulation::Impl::soft_contact(std::size_t body, std::uint32_t vertex, const Distance& distance,
                                       const Collider& collider) const {
  Contact c;
  c.a = surface_side(body, vertex);
  c.point = surfaces[body].positions()[vertex];
  c.normal = distance.normal;
  c.gap = distance.value;
  if (!collider.fixed) {
    c.b.kind = ContactSide::Kind::rigid;
    c.b.arm = c.point - collider.pose.p;
  }
  c.b.body = collider.slot;
  c.stiffness = model.contact_stiffness(body, vertex);
  c.friction = std::sqrt(model.soft[body]->desc().friction * collider.friction);
  return c;
}

Contact Simulation::Impl::soft_contact(std::size_t body, const TriangleTouch& touch,
                                       const Collider& collider) const {
  const Anatomy& anatomy = model.soft[body]->anatomy();
  const auto& corners = anatomy.surface.triangles[touch.triangle];
  Contact c = soft_contact(body, corners[0], {touch.gap, touch.normal}, collider);
  c.a.nodes = 0;
  c.a.weight = {};
  c.stiffness = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double share = touch.weights[static_cast<Eigen::Index>(k)];
    c.a.add(anatomy.embedding.rows[corners[k]], share);
    c.stiffness += touch.strength * share * model.contact_stiffness(body, corners[k]);
  }
  c.point = touch.point;
  if (!collider.fixed) c.b.arm = c.point - collider.pose.p;
  return c;
}

bool Simulation::Impl::add_contacts(std::size_t body, const Collider& collider, double margin,
                                    std::vector<Contact>& out) const {
  if (rough[body]) return add_rough_contacts(body, collider, margin, out);
  const std::size_t before = out.size();
  const double skin = skin_of(body);
  surfaces[body].near(collider, margin + skin, [&](std::uint32_t vertex, Distance d) {
    d.value -= skin;
    if (collider.fixed || surfaces[body].stretch_at(vertex) < most_stretch)
      out.push_back(soft_contact(body, vertex, d, collider));
  });
  surfaces[body].near_thin(collider, margin + skin, [&](TriangleTouch touch) {
    touch.gap -= skin;
    out.push_back(soft_contact(body, touch, collider));
  });
  return out.size() > before;
}

bool Simulation::Impl::touches(std::size_t body, const Collider& collider, double margin) const {
  if (!rough[body]) return surfaces[body].touches(collider, margin + skin_of(body));
  std::vector<Contact> found;
  return add_rough_contacts(body, collider, margin, found);
}

bool Simulation::Impl::may_meet(std::size_t body, const Collider& collider) const {
  const SoftCollision& own = model.soft_collision[body];
  return collider.parts && own.fidelity != Fidelity::none && may_touch(own.mask, world.mask(collider.slot));
}

void Simulation::Impl::wake_soft(std::size_t body) {
  soft[body].asleep = false;
  soft[body].quiet_ticks = 0;
}

void Simulation::Impl::detect_soft_contacts() {
  refresh_colliders();
  const double h = model.h;
  for (auto& list : soft_contacts) list.clear();
  std::fill(faces_moved.begin(), faces_moved.end(), 0);
  track_soft_bodies();
  const auto awake = [&](const Collider& c) { return !c.fixed && !world.motion(c.slot).asleep; };
  // Waking spreads until nobody wakes any more: tissue wakes what rests on it, and the other way round.
  std::vector<char> done(soft.size(), 0);
  for (bool again = true; again;) {
    again = false;
    for (std::size_t i = 0; i < soft.size(); ++i) {
      if (done[i] || parts[soft_id(i)].out_of_touch()) continue;
      if (soft[i].asleep) {
        const bool touched = std::any_of(colliders.begin(), colliders.end(), [&](const Collider& c) {
          if (!may_meet(i, c) || !awake(c)) return false;
          std::vector<Contact> found;
          return touches(i, c, wake_margin + std::min(most_reach, h * total_speed(c))) ||
                 (is_swept(i, c) && add_swept_contacts(i, c, contact_margin, found));
        });
        if (!touched && !woken_by_soft(i)) continue;
        wake_soft(i);
      }
      done[i] = 1;
      again = true;
      place_surface(i);
      const double own = h * soft[i].motion.v.lpNorm<Eigen::Infinity>();
      for (const Collider& c : colliders) {
        if (!may_meet(i, c)) continue;
        const double reach = std::min(most_reach, own + std::max(c.pull, h * total_speed(c)));
        const bool touched = is_swept(i, c)
                                 ? add_swept_contacts(i, c, contact_margin + reach, soft_contacts[i])
                                 : add_contacts(i, c, contact_margin + reach, soft_contacts[i]);
        if (touched && !c.fixed && world.motion(c.slot).asleep) world.wake(c.slot);
      }
    }
  }
  detect_soft_pairs();
}

}  // namespace prosector
