// After the step: bones that broke in it.

#include <algorithm>

#include "server/physics/coupled/potentials.h"
#include "server/physics/simulation_impl.h"

namespace prosector {

Part Simulation::Impl::initial_part(BodyId body) const {
  Part out;
  out.hidden = !is_soft(body) && model.rigid[body].whole.has_value();
  return out;
}

std::vector<Part> Simulation::Impl::initial_parts(std::size_t soft_bodies) const {
  std::vector<Part> out;
  for (BodyId body = 0; body < model.rigid.size() + soft_bodies; ++body) out.push_back(initial_part(body));
  return out;
}

/// Point forces on a rigid body in this tick, besides gravity; room frame. Of contacts that the coupled
/// solver solved, along their normals; of one that is held in its place, those alone.
std::vector<Simulation::Impl::PointForce> Simulation::Impl::forces_on(std::size_t slot) const {
  std::vector<PointForce> out;
  bool mixed = false;
  const bool held = !world.dynamic(slot);
  for (const Island& island : islands) {
    if (!held && std::none_of(island.rigid.begin(), island.rigid.end(),
                              [&](const RigidMember& r) { return r.slot == slot; }))
      continue;
    mixed = true;
    const auto is_it = [&](const ContactSide& side) {
      return side.kind != ContactSide::Kind::soft && side.body == slot;
    };
    for (const Contact& c : island.contacts) {
      if (is_it(c.a)) out.push_back({c.point, c.force * c.normal});
      if (is_it(c.b)) out.push_back({c.point, -c.force * c.normal});
    }
  }
  if (!mixed && !held)
    for (const RigidImpulse& i : world.impulses(slot)) out.push_back({i.point, i.impulse / step_h});
  for (const Hand& hand : hands) {
    if (!hand.hold || hand.hold->body != slot) continue;
    const Pose at_hand = world.motion(hand.slot).pose, at_body = world.motion(slot).pose;
    for (const Hold::Point& p : hand.hold->points) {
      const Vec3 stretch = at_hand * p.in_hand - at_body * p.in_body;
      out.push_back(
          {at_body * p.in_body, BoundedSpring{p.stiffness, p.max_force}.secant(stretch.norm()) * stretch});
    }
  }
  return out;
}

/// Of a body that moves or may: what either side needs to move as it does, less what acts on it.
double Simulation::Impl::force_through_free(BodyId body, const RigidModel::Fracture& plane,
                                            const PlaneLoad& load) const {
  const RigidMotion now = world.motion(body);
  const Collider& before = colliders[body];  // as the tick began
  const Vec3 linear = (now.linear_velocity - before.linear) / step_h;
  const Vec3 angular = (now.angular_velocity - before.angular) / step_h;
  const auto acceleration = [&](const Vec3& center) -> Vec3 {
    const Vec3 arm = now.pose.q * center;
    return linear + angular.cross(arm) + now.angular_velocity.cross(now.angular_velocity.cross(arm)) -
           model.scene.gravity;
  };
  return force_through(plane, model.rigid[body].setup.mass, acceleration(plane.center_above),
                       acceleration(plane.center_below), load)
      .norm();
}

/// Of a part in its place, which holds it by the side of its centre of mass: what acts on the other side.
double Simulation::Impl::force_through_held(BodyId body, const RigidModel::Fracture& plane,
                                            const PlaneLoad& load) const {
  const double mass = model.rigid[body].setup.mass;
  const bool holds_above = plane.normal.dot(plane.point) < 0;  // the centre of mass is the origin
  const double free_mass = holds_above ? mass - plane.mass_above : plane.mass_above;
  return ((holds_above ? load.below : load.above) + free_mass * model.scene.gravity).norm();
}

void Simulation::Impl::break_bones() {
  for (BodyId body = 0; body < model.rigid.size(); ++body) {
    const RigidModel& bone = model.rigid[body];
    if (bone.fractures.empty() || colliders[body].parts == nullptr) continue;  // or it broke off just now
    const bool held = world.presence(body) == BodyPresence::fixed;
    if (!held && (!world.dynamic(body) || world.motion(body).asleep)) continue;
    const Pose pose = world.motion(body).pose;
    const std::vector<PointForce> forces = forces_on(body);
    if (held && forces.empty()) continue;
    double most = model.scene.rigid[body].break_force;
    const RigidModel::Fracture* weakest = nullptr;
    for (const RigidModel::Fracture& plane : bone.fractures) {
      PlaneLoad load;
      for (const PointForce& f : forces) {
        const bool above = plane.normal.dot(pose.inverse() * f.point - plane.point) > 0;
        (above ? load.above : load.below) += f.force;
      }
      const double force =
          held ? force_through_held(body, plane, load) : force_through_free(body, plane, load);
      if (force <= most) continue;
      most = force;
      weakest = &plane;
    }
    if (weakest != nullptr) break_at(body, *weakest, most);
  }
}

/// The pieces go on with the whole's motion, so its momentum and angular momentum are theirs.
void Simulation::Impl::break_at(BodyId body, const RigidModel::Fracture& plane, double force) {
  const RigidMotion whole = world.motion(body);
  const Pose frame = whole.pose * model.rigid[body].center.inverse();
  for (const std::size_t piece : {plane.above, plane.below}) {
    parts[piece] = {};
    take_effect(world, static_cast<BodyId>(piece));
    RigidMotion motion;
    motion.pose = frame * model.rigid[piece].center;
    motion.linear_velocity =
        whole.linear_velocity + whole.angular_velocity.cross(motion.pose.p - whole.pose.p);
    motion.angular_velocity = whole.angular_velocity;
    world.set_motion(piece, motion);
  }
  for (Hand& hand : hands)
    if (hand.hold && hand.hold->body == body) hand_over(hand, plane);
  parts[body].hidden = true;
  take_effect(world, body);
  wake_everything();
  report.broken.push_back({body, force});
}

/// A hold goes on with the piece that most of it is on.
void Simulation::Impl::hand_over(Hand& hand, const RigidModel::Fracture& plane) {
  Hold& hold = *hand.hold;
  const auto above = std::count_if(hold.points.begin(), hold.points.end(), [&](const Hold::Point& p) {
    return plane.normal.dot(p.in_body - plane.point) > 0;
  });
  const std::size_t piece =
      2 * above >= static_cast<std::ptrdiff_t>(hold.points.size()) ? plane.above : plane.below;
  const Pose to_piece = world.motion(piece).pose.inverse() * world.motion(hold.body).pose;
  for (Hold::Point& p : hold.points) p.in_body = to_piece * p.in_body;
  world.set_collides(hand.slot, hold.body, true);
  world.set_collides(hand.slot, piece, false);
  hold.body = static_cast<BodyId>(piece);
}

}  // namespace prosector
