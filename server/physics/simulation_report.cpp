// Phase 8: what the step did, and where the hands are.

#include <algorithm>

#include "server/physics/simulation_impl.h"

namespace prosector {
namespace {

/// Which body a contact's side belongs to.
BodyId body_of(const ContactSide& side, std::size_t rigid_count) {
  return static_cast<BodyId>(side.kind == ContactSide::Kind::soft ? rigid_count + side.body : side.body);
}

/// Adds one contact of a hand: impulses and normal forces sum up, the rest is of the strongest.
void note(ContactSample& sample, const Contact& c, bool hand_is_b, double h, std::size_t rigid_count,
          double& strongest) {
  if (!(c.force > 0)) return;
  const Vec3 outward = hand_is_b ? Vec3(-c.normal) : c.normal;
  sample.impulse += c.force * h;
  sample.force -= c.force * outward;
  if (c.force <= strongest) return;
  strongest = c.force;
  sample.touching = true;
  sample.body = body_of(hand_is_b ? c.a : c.b, rigid_count);
  sample.point = c.point;
  sample.normal = outward;
  sample.depth = c.force / c.stiffness;
}

}  // namespace

void Simulation::Impl::describe() {
  report.time = time;
  for (const Island& island : islands) report.contacts += static_cast<std::uint32_t>(island.contacts.size());
  for (std::size_t slot = 0; slot < model.rigid.size(); ++slot) {
    if (!world.dynamic(slot)) continue;
    const RigidMotion motion = world.motion(slot);
    const RigidSetup& setup = model.rigid[slot].setup;
    const Vec3 spin = motion.pose.q.conjugate() * motion.angular_velocity;
    ++(motion.asleep ? report.asleep_bodies : report.awake_bodies);
    report.kinetic_energy +=
        (setup.mass * motion.linear_velocity.squaredNorm() + spin.dot(setup.inertia.cwiseProduct(spin))) / 2;
    report.potential_energy -= setup.mass * model.scene.gravity.dot(motion.pose.p);
  }
  for (std::size_t i = 0; i < soft.size(); ++i) {
    SoftBody& body = *model.soft[i];
    ++(soft[i].asleep ? report.asleep_bodies : report.awake_bodies);
    if (soft[i].asleep) continue;
    report.kinetic_energy += body.kinetic_energy(soft[i]);
    report.elastic_energy += body.in_force(soft[i]).elastic_energy(soft[i].motion.x);
    if (!body.falls()) continue;
    for (Eigen::Index n = 0; n < body.nodes(); ++n)
      report.potential_energy -=
          body.node_mass()[n] * model.scene.gravity.dot(soft[i].motion.x.segment<3>(3 * n));
  }
  describe_hands();
}

void Simulation::Impl::describe_hands() {
  hand_states.clear();
  for (const Hand& hand : hands) {
    HandState& state = hand_states.emplace_back();
    state.participant = hand.participant;
    state.hand = hand.side;
    state.pose = world.motion(hand.slot).pose * model.hands[hand.side].center.inverse();
    state.flexion = hand.flexion;
    if (hand.hold) state.holding = hand.hold->body;
    ContactSample& sample = state.contact;
    sample.participant = hand.participant;
    sample.hand = static_cast<std::uint8_t>(hand.side);
    sample.time = time;
    double strongest = 0;
    for (const Island& island : islands)
      for (const Contact& c : island.contacts)
        for (const bool hand_is_b : {false, true}) {
          const ContactSide& side = hand_is_b ? c.b : c.a;
          if (side.kind == ContactSide::Kind::rigid && side.body == hand.slot)
            note(sample, c, hand_is_b, model.h, model.rigid.size(), strongest);
        }
    if (hand.hold) add_hold(sample, hand);
  }
}

}  // namespace prosector
