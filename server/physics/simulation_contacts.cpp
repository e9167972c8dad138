// Phase 3: which soft surfaces touch which rigid bodies, and who wakes whom by it.

#include <algorithm>

#include "server/physics/contact/facing.h"
#include "server/physics/simulation_impl.h"

namespace prosector {
namespace {

// Stretch of the surface at which a moving thing loses hold of it: real tissue would have torn long before,
// and what a leaping hand has hooked would never come free.
constexpr double most_stretch = 3;
constexpr double lip = 0.1;  // surface cells: what an edge runs over

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
    c.driven_to = world.driven_to(slot);
    if (hand)
      c.pull = std::min(most_reach, ((hand->target * model.hands[hand->side].center).p - c.pose.p).norm());
  }
  for (std::size_t side = 0; side < model.room.size(); ++side) colliders.push_back(room_collider(side));
}

Collider Simulation::Impl::room_collider(std::size_t side) const {
  const RigidShape& shape = model.room[side].shape;
  const ShapePart& solid = shape.parts.front();
  Collider c;
  c.slot = room_slot(side);
  c.parts = &shape.parts;
  c.distances = &shape.distances;
  c.part_poses = {solid.pose};
  c.lo = solid.pose.p - solid.half;
  c.hi = solid.pose.p + solid.half;
  c.friction = room_friction;
  c.fixed = true;
  return c;
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

Vec3 Simulation::Impl::driven_way(const Collider& collider, const Vec3& point) {
  if (!collider.driven_to) return Vec3::Zero();
  const Vec3 way = *collider.driven_to * (collider.pose.inverse() * point) - point;
  return way * std::min(1.0, most_reach / std::max(way.norm(), most_reach));
}

Contact Simulation::Impl::soft_contact(std::size_t body, const Vec3& point, const Distance& distance,
                                       const Collider& collider) const {
  Contact c;
  c.a.kind = ContactSide::Kind::soft;
  c.a.body = body;
  c.point = point;
  c.normal = distance.normal;
  c.gap = distance.value;
  c.b.body = collider.slot;
  if (!collider.fixed) {
    c.b.kind = ContactSide::Kind::rigid;
    c.b.arm = point - collider.pose.p;
  }
  c.b.moved = driven_way(collider, point);
  c.friction = std::sqrt(model.soft[body]->desc().friction * collider.friction);
  return c;
}

Contact Simulation::Impl::vertex_contact(std::size_t body, std::uint32_t vertex, const Distance& distance,
                                         const Collider& collider) const {
  Contact c = soft_contact(body, surfaces[body].positions()[vertex], distance, collider);
  c.a.add(model.soft[body]->anatomy().embedding.rows[vertex], 1);
  c.stiffness = model.contact_stiffness(body, vertex);
  c.feature = vertex;
  return c;
}

Contact Simulation::Impl::face_contact(std::size_t body, const TriangleTouch& touch,
                                       const Collider& collider) const {
  const Anatomy& anatomy = model.soft[body]->anatomy();
  const auto& corners = anatomy.surface.triangles[touch.triangle];
  Contact c = soft_contact(body, touch.point, {touch.gap, touch.normal}, collider);
  for (std::size_t k = 0; k < 3; ++k) {
    const double share = touch.weights[static_cast<Eigen::Index>(k)];
    c.a.add(anatomy.embedding.rows[corners[k]], share);
    c.stiffness += touch.strength * share * model.contact_stiffness(body, corners[k]);
  }
  return c;
}

bool Simulation::Impl::add_contacts(std::size_t body, const Collider& collider, double margin,
                                    const ContactMemories& held, std::vector<Contact>& out) const {
  if (rough[body]) return add_rough_contacts(body, collider, margin, out);
  const std::size_t before = out.size();
  const double skin = skin_of(body);
  const Vec3 near = Vec3::Constant(margin + skin);
  if (is_room(collider.slot) &&
      !boxes_overlap(collider.lo - near, collider.hi + near, surfaces[body].lo(), surfaces[body].hi()))
    return false;
  const bool still = collider.fixed && !collider.driven_to;
  const TriangleMesh& surface = model.soft[body]->anatomy().surface;
  const auto first_face = static_cast<std::uint32_t>(surface.positions.size());
  const auto first_corner = first_face + static_cast<std::uint32_t>(surface.triangles.size());
  ContactSide other;
  other.body = collider.slot;
  surfaces[body].near(collider, margin + skin, [&](std::uint32_t vertex, Distance d) {
    const ContactMemory* memory = find(held, other, vertex);
    Approach approach{surfaces[body].positions()[vertex], d};
    if (memory) {
      approach.before = &memory->normal;
      approach.depth = memory->force / model.contact_stiffness(body, vertex);
    }
    if (skin == 0) approach.outward = surfaces[body].outward_at(vertex);
    approach.lip = lip * model.soft[body]->desc().surface_cell;
    std::optional<Distance> side = side_of(collider, approach);
    if (!side) return;
    side->value -= skin;
    if (!still && surfaces[body].stretch_at(vertex) >= most_stretch) return;
    recall(memory, out.emplace_back(vertex_contact(body, vertex, *side, collider)));
  });
  const KnownSide known = [&](std::uint32_t triangle) -> std::optional<Vec3> {
    if (const ContactMemory* own = find(held, other, first_face + triangle)) return own->normal;
    for (const std::uint32_t next : surfaces[body].neighbours(triangle))
      if (const ContactMemory* near = find(held, other, first_face + next)) return near->normal;
    return std::nullopt;
  };
  // Without a grip: what rolls over a face holds on to no point of it. A corner does not roll.
  surfaces[body].near_thin(collider, margin + skin, known, [&](TriangleTouch touch) {
    touch.gap -= skin;
    out.push_back(face_contact(body, touch, collider));
    out.back().feature = first_face + touch.triangle;
  });
  if (skin == 0)
    box_corners(collider, margin, surfaces[body].lo(), surfaces[body].hi(), [&](const BoxCorner& corner) {
      const auto touch = surfaces[body].near_corner(collider, corner.at, margin, corner.depth);
      if (!touch) return;
      out.push_back(face_contact(body, *touch, collider));
      out.back().feature = first_corner + corner.index;
      recall(find(held, other, out.back().feature), out.back());
    });
  rest(held, first_face, step_h, std::span(out).subspan(before));
  return out.size() > before;
}

bool Simulation::Impl::touches(std::size_t body, const Collider& collider, double margin) const {
  if (!rough[body]) return surfaces[body].touches(collider, margin + skin_of(body));
  std::vector<Contact> found;
  return add_rough_contacts(body, collider, margin, found);
}

bool Simulation::Impl::may_meet(std::size_t body, const Collider& collider) const {
  const SoftCollision& own = model.soft_collision[body];
  if (is_room(collider.slot) && has_side(own.passes, room_side(collider.slot))) return false;
  return collider.parts && !is_held_blade(collider.slot) && own.fidelity != Fidelity::none &&
         may_touch(own.mask, world.mask(collider.slot));
}

void Simulation::Impl::wake_soft(std::size_t body) {
  soft[body].asleep = false;
  soft[body].quiet_ticks = 0;
}

void Simulation::Impl::detect_soft_contacts() {
  refresh_colliders();
  for (auto& list : soft_contacts) list.clear();
  std::fill(faces_moved.begin(), faces_moved.end(), 0);
  std::fill(layers_moved.begin(), layers_moved.end(), 0);
  for (InsideOut& known : inside_out) known.known = false;
  track_soft_bodies();
  const auto awake = [&](const Collider& c) {
    return c.driven_to || (!c.fixed && !world.motion(c.slot).asleep);
  };
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
          return touches(i, c, wake_margin + std::min(most_reach, step_h * total_speed(c))) ||
                 (is_swept(i, c) && add_swept_contacts(i, c, contact_margin, found));
        });
        if (!touched && !woken_by_soft(i)) continue;
        wake_soft(i);
      }
      done[i] = 1;
      again = true;
      place_surface(i);
      const double own = step_h * soft[i].motion.v.lpNorm<Eigen::Infinity>();
      for (const Collider& c : colliders) {
        if (!may_meet(i, c)) continue;
        const double reach =
            is_room(c.slot) ? own : std::min(most_reach, own + std::max(c.pull, step_h * total_speed(c)));
        const bool touched = is_swept(i, c)
                                 ? add_swept_contacts(i, c, contact_margin + reach, soft_contacts[i])
                                 : add_contacts(i, c, contact_margin + reach, memories[i], soft_contacts[i]);
        if (touched && !c.fixed && world.motion(c.slot).asleep) world.wake(c.slot);
      }
    }
  }
  detect_soft_pairs();
}

}  // namespace prosector
