#include "server/physics/stations/parts/breaking.h"

#include <algorithm>
#include <vector>

#include "server/physics/stations/hands/holding.h"
#include "server/physics/stations/parts/fracture.h"

namespace prosector {
namespace {

struct PointForce {
  Vec3 point, force;  // m, N
};

/// Returns the point forces on a rigid body in this tick, without gravity; world frame. Contacts of the
/// coupled solver count along their normals. For an attached body only these count.
std::vector<PointForce> forces_on(const Bodies& bodies, std::span<const hands::Hand> hands,
                                  std::span<const coupled::Island> islands, std::size_t slot, double h) {
  std::vector<PointForce> out;
  bool mixed = false;
  const bool held = !bodies.rigid.dynamic(slot);
  for (const coupled::Island& island : islands) {
    if (!held && std::none_of(island.rigid.begin(), island.rigid.end(),
                              [&](const coupled::RigidMember& r) { return r.slot == slot; }))
      continue;
    mixed = true;
    const auto is_it = [&](const contact::ContactSide& side) {
      return side.kind != contact::ContactSide::Kind::soft && side.body == slot;
    };
    for (const contact::Contact& c : island.contacts) {
      if (is_it(c.a)) out.push_back({c.point, c.force * c.normal});
      if (is_it(c.b)) out.push_back({c.point, -c.force * c.normal});
    }
  }
  if (!mixed && !held)
    for (const rigid::RigidImpulse& i : bodies.rigid.impulses(slot)) out.push_back({i.point, i.impulse / h});
  for (const hands::Hand& hand : hands)
    if (hand.hold && hand.hold->body == slot)
      for (const HeldPoint& p : held_points(bodies, hand)) out.push_back({p.at_body, p.force()});
  return out;
}

/// Returns the force through the plane of a free body, N: the inertial force of either side minus the forces
/// on it.
double force_through_free(const Bodies& bodies, std::span<const contact::Collider> colliders, BodyId body,
                          const RigidModel::Fracture& plane, const PlaneLoad& load, double h) {
  const rigid::RigidMotion now = bodies.rigid.motion(body);
  const contact::Collider& before = colliders[body];  // at the tick's start
  const Vec3 linear = (now.linear_velocity - before.linear) / h;
  const Vec3 angular = (now.angular_velocity - before.angular) / h;
  const auto acceleration = [&](const Vec3& center) -> Vec3 {
    const Vec3 arm = now.pose.q * center;
    return linear + angular.cross(arm) + now.angular_velocity.cross(now.angular_velocity.cross(arm)) -
           bodies.model.scene.gravity;
  };
  return force_through(plane, bodies.model.rigid[body].setup.mass, acceleration(plane.center_above),
                       acceleration(plane.center_below), load)
      .norm();
}

/// Returns the force through the plane of an attached part, N. It is held on the side of its centre of mass,
/// so the force is the load on the other side.
double force_through_held(const Bodies& bodies, BodyId body, const RigidModel::Fracture& plane,
                          const PlaneLoad& load) {
  const double mass = bodies.model.rigid[body].setup.mass;
  const bool holds_above = plane.normal.dot(plane.point) < 0;  // the centre of mass is the origin
  const double free_mass = holds_above ? mass - plane.mass_above : plane.mass_above;
  return ((holds_above ? load.below : load.above) + free_mass * bodies.model.scene.gravity).norm();
}

/// Breaks the body. The pieces keep the whole's motion, which conserves momentum and angular momentum.
void break_at(State& state, BodyId body, const RigidModel::Fracture& plane, double force,
              StepReport& report) {
  Bodies& bodies = state.bodies;
  const rigid::RigidMotion whole = bodies.rigid.motion(body);
  const Pose frame = whole.pose * bodies.model.rigid[body].center.inverse();
  for (const std::size_t piece : {plane.above, plane.below}) {
    bodies.parts[piece] = {};
    bodies.take_effect(bodies.rigid, static_cast<BodyId>(piece));
    rigid::RigidMotion motion;
    motion.pose = frame * bodies.model.rigid[piece].center;
    motion.linear_velocity =
        whole.linear_velocity + whole.angular_velocity.cross(motion.pose.p - whole.pose.p);
    motion.angular_velocity = whole.angular_velocity;
    bodies.rigid.set_motion(piece, motion);
  }
  for (hands::Hand& hand : state.hands)
    if (hand.hold && hand.hold->body == body) hand_over(bodies, hand, plane);
  bodies.parts[body].hidden = true;
  bodies.take_effect(bodies.rigid, body);
  bodies.wake_everything();
  report.broken.push_back({body, force});
}

}  // namespace

void break_bones(State& state, std::span<const coupled::Island> islands,
                 std::span<const contact::Collider> colliders, double h, StepReport& report) {
  Bodies& bodies = state.bodies;
  for (BodyId body = 0; body < bodies.model.rigid.size(); ++body) {
    const RigidModel& bone = bodies.model.rigid[body];
    // A piece that broke off in this tick has no collider parts yet.
    if (bone.fractures.empty() || colliders[body].parts == nullptr) continue;
    const bool held = bodies.rigid.presence(body) == rigid::BodyPresence::fixed;
    if (!held && (!bodies.rigid.dynamic(body) || bodies.rigid.motion(body).asleep)) continue;
    const Pose pose = bodies.rigid.motion(body).pose;
    const std::vector<PointForce> forces = forces_on(bodies, state.hands, islands, body, h);
    if (held && forces.empty()) continue;
    double most = bodies.model.scene.rigid[body].break_force;
    const RigidModel::Fracture* weakest = nullptr;
    for (const RigidModel::Fracture& plane : bone.fractures) {
      PlaneLoad load;
      for (const PointForce& f : forces) {
        const bool above = plane.normal.dot(pose.inverse() * f.point - plane.point) > 0;
        (above ? load.above : load.below) += f.force;
      }
      const double force = held ? force_through_held(bodies, body, plane, load)
                                : force_through_free(bodies, colliders, body, plane, load, h);
      if (force <= most) continue;
      most = force;
      weakest = &plane;
    }
    if (weakest != nullptr) break_at(state, body, *weakest, most, report);
  }
}

}  // namespace prosector
