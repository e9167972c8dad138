#include "server/physics/stations/report.h"

#include <algorithm>

#include "server/physics/mechanics/contact/flat_elements.h"
#include "server/physics/mechanics/soft/incremental_potential.h"
#include "server/physics/mechanics/soft/mechanical_energy.h"
#include "server/physics/stations/hands/holding.h"

namespace prosector {
namespace {

constexpr double latest_impact = 1;  // s: later predicted impacts are not reported

/// Returns the body of a contact's side.
BodyId body_of(const contact::ContactSide& side, std::size_t rigid_count) {
  return static_cast<BodyId>(side.kind == contact::ContactSide::Kind::soft ? rigid_count + side.body
                                                                           : side.body);
}

/// Returns the velocity of a contact's side at the tick's end, m/s.
Vec3 velocity_of(const contact::ContactSide& side, const Bodies& bodies, double h) {
  if (side.kind == contact::ContactSide::Kind::fixed) return side.moved / h;
  if (side.kind == contact::ContactSide::Kind::rigid) {
    const rigid::RigidMotion motion = bodies.rigid.motion(side.body);
    return motion.linear_velocity + motion.angular_velocity.cross(side.arm);
  }
  Vec3 v = Vec3::Zero();
  for (std::size_t k = 0; k < side.nodes; ++k)
    v += side.weight[k] *
         bodies.soft[side.body].state.motion.v.segment<3>(3 * static_cast<Eigen::Index>(side.node[k]));
  return v;
}

/// Returns the body's elastic and gravitational energy in its current shape.
Tissue::StoredEnergy stored_in(const Tissue& tissue, const Vec3& gravity) {
  soft::SoftBody& body = *tissue.solver;
  const VecX& x = tissue.state.motion.x;
  Tissue::StoredEnergy out;
  out.elastic = body.in_force(tissue.state).potential().elastic_energy(x);
  const soft::Weight weight = body.weight(gravity, body.attached());
  for (Eigen::Index n = 0; n < body.nodes(); ++n)
    out.weight -= body.node_mass()[n] * weight.at(n).dot(x.segment<3>(3 * n));
  return out;
}

/// Adds one contact to a hand's sample. Impulse and force are summed over pressing contacts; point, normal
/// and depth are those of the strongest contact. If none presses, the sample has the contact with the
/// earliest impact, extrapolated from the velocities at the tick's end.
void add_contact(const Bodies& bodies, std::span<const contact::Collider> colliders, ContactSample& sample,
                 const contact::Contact& c, bool hand_is_b, double& strongest, double h) {
  if (c.bearer > 0) {  // friction of a contact that is reported separately
    sample.force += hand_is_b ? c.exchanged : Vec3(-c.exchanged);
    return;
  }
  const double gap = c.gap + c.rest - c.spread;  // gap until the contact begins to press
  if (c.force > 0) {
    sample.impulse += c.force * bodies.model.h;
    sample.force += hand_is_b ? c.exchanged : Vec3(-c.exchanged);
    if (c.force <= strongest) return;
    strongest = c.force;
    sample.touching = true;
    sample.depth = c.force / c.stiffness - c.rest;
    sample.impact = gap > 0 ? bodies.model.h * gap / (gap + sample.depth) : 0;
  } else {
    const double closing = -c.normal.dot(velocity_of(c.a, bodies, h) - velocity_of(c.b, bodies, h));
    if (sample.touching || gap <= 0 || gap > latest_impact * closing) return;
    const double impact = gap / closing;
    if (sample.impact >= 0 && impact >= sample.impact) return;
    sample.depth = closing * bodies.model.h - gap;
    sample.impact = impact;
  }
  const contact::ContactSide& met = hand_is_b ? c.a : c.b;
  sample.body = body_of(met, bodies.model.rigid.size());
  sample.point = c.point;
  sample.normal = hand_is_b ? Vec3(-c.normal) : c.normal;
  sample.local_point.setZero();
  if (met.kind == contact::ContactSide::Kind::soft)
    for (std::size_t k = 0; k < met.nodes; ++k)
      sample.local_point += met.weight[k] * bodies.soft[met.body].solver->rest().segment<3>(
                                                3 * static_cast<Eigen::Index>(met.node[k]));
  else if (met.body < bodies.model.rigid.size())
    sample.local_point = bodies.model.rigid[met.body].center * (colliders[met.body].pose.inverse() * c.point);
}

/// Adds all contacts to the samples of their hands. `hand_states` is parallel to the state's hands.
void add_hand_contacts(const State& state, std::span<const coupled::Island> islands,
                       std::span<const contact::Collider> colliders, std::vector<HandState>& hand_states,
                       double h) {
  // By slot; `hand_states.size()` for slots without a hand.
  std::vector<std::size_t> hand_at(state.bodies.rigid.slots(), hand_states.size());
  for (std::size_t i = 0; i < hand_states.size(); ++i) hand_at[state.hands[i].slot] = i;
  std::vector<double> strongest(hand_states.size(), 0);  // N
  for (const coupled::Island& island : islands)
    for (const contact::Contact& c : island.contacts)
      for (const bool hand_is_b : {false, true}) {
        const contact::ContactSide& side = hand_is_b ? c.b : c.a;
        if (side.kind != contact::ContactSide::Kind::rigid || hand_at[side.body] == hand_states.size())
          continue;
        const std::size_t i = hand_at[side.body];
        add_contact(state.bodies, colliders, hand_states[i].contact, c, hand_is_b, strongest[i], h);
      }
}

/// Adds a hold to a hand's sample. A held body counts as touched, although the hand doesn't collide with it.
/// The hold's force counts as the hand's force.
void add_hold(const Bodies& bodies, ContactSample& sample, const hands::Hand& hand) {
  const hands::Hold& hold = *hand.hold;
  const Vec3 force = hold_force(bodies, hand);
  sample.force += force;
  sample.impulse += force.norm() * bodies.model.h;
  if (sample.touching) return;
  sample.touching = true;
  sample.body = hold.body;
  sample.point = Vec3::Zero();
  for (const HeldPoint& p : held_points(bodies, hand))
    sample.point += p.at_body / static_cast<double>(hold.points.size());
  if (force.norm() > 0) sample.normal = -force.normalized();
}

}  // namespace

void describe(State& state, std::span<const coupled::Island> islands, StepReport& report) {
  Bodies& bodies = state.bodies;
  report.time = state.time;
  for (const coupled::Island& island : islands)
    report.contacts += static_cast<std::uint32_t>(std::count_if(
        island.contacts.begin(), island.contacts.end(),
        [](const contact::Contact& c) { return c.bearer == 0 && !contact::within_element(c); }));
  for (std::size_t slot = 0; slot < bodies.model.rigid.size(); ++slot) {
    if (!bodies.rigid.dynamic(slot)) continue;
    const rigid::RigidMotion motion = bodies.rigid.motion(slot);
    const rigid::RigidSetup& setup = bodies.model.rigid[slot].setup;
    const Vec3 spin = motion.pose.q.conjugate() * motion.angular_velocity;
    ++(motion.asleep ? report.asleep_bodies : report.awake_bodies);
    report.kinetic_energy +=
        (setup.mass * motion.linear_velocity.squaredNorm() + spin.dot(setup.inertia.cwiseProduct(spin))) / 2;
    report.potential_energy -= setup.mass * bodies.model.scene.gravity.dot(motion.pose.p);
  }
  for (Tissue& tissue : bodies.soft) {
    ++(tissue.state.asleep ? report.asleep_bodies : report.awake_bodies);
    report.kinetic_energy += soft::kinetic_energy(tissue.solver->node_mass(), tissue.state.motion.v);
    if (!tissue.state.asleep || !tissue.stored) tissue.stored = stored_in(tissue, bodies.model.scene.gravity);
    report.elastic_energy += tissue.stored->elastic;
    report.potential_energy += tissue.stored->weight;
  }
}

std::vector<HandState> describe_hands(const State& state, std::span<const coupled::Island> islands,
                                      std::span<const contact::Collider> colliders, double h) {
  const Bodies& bodies = state.bodies;
  std::vector<HandState> out;
  for (const hands::Hand& hand : state.hands) {
    HandState& reported = out.emplace_back();
    reported.participant = hand.participant;
    reported.hand = hand.side;
    reported.pose = bodies.rigid.motion(hand.slot).pose * bodies.model.hands[hand.side].center.inverse();
    reported.flexion = hand.flexion;
    if (hand.hold) reported.holding = hand.hold->body;
    ContactSample& sample = reported.contact;
    sample.participant = hand.participant;
    sample.hand = static_cast<std::uint8_t>(hand.side);
    sample.time = state.time;
  }
  add_hand_contacts(state, islands, colliders, out, h);
  for (std::size_t i = 0; i < out.size(); ++i)
    if (state.hands[i].hold) add_hold(bodies, out[i].contact, state.hands[i]);
  return out;
}

std::vector<Exchange> exchanges(std::vector<Exchange> earlier, std::span<const coupled::Island> islands,
                                std::size_t rigid_bodies, double h) {
  std::vector<Exchange> out = std::move(earlier);
  std::vector<double> strongest(out.size(), 0);               // N, by exchange
  const auto named = [&](const contact::ContactSide& side) {  // excludes hands
    return side.kind == contact::ContactSide::Kind::soft || side.body < rigid_bodies;
  };
  // A pair's contacts are consecutive; for two soft bodies, sides a and b may be swapped.
  const auto at = [&](BodyId a, BodyId b) {
    const auto same = [&](const Exchange& e) { return (e.a == a && e.b == b) || (e.a == b && e.b == a); };
    const auto last = std::find_if(out.rbegin(), out.rend(), same);
    if (last != out.rend()) return static_cast<std::size_t>(out.rend() - last) - 1;
    out.push_back({a, b});
    strongest.push_back(0);
    return out.size() - 1;
  };
  for (const coupled::Island& island : islands)
    for (const contact::Contact& c : island.contacts) {
      if (!(c.force > 0 || !c.exchanged.isZero(0)) || !named(c.a) || !named(c.b) ||
          contact::within_element(c))
        continue;
      const BodyId a = body_of(c.a, rigid_bodies), b = body_of(c.b, rigid_bodies);
      const std::size_t i = at(a, b);
      Exchange& pair = out[i];
      const double sign = pair.a == a ? 1 : -1;
      ++pair.points;
      pair.impulse += sign * h * c.exchanged;
      pair.normal_impulse += h * c.normal.dot(c.exchanged);
      pair.depth = std::max(pair.depth, -(c.gap + c.rest));
      if (c.force <= strongest[i]) continue;
      strongest[i] = c.force;
      pair.point = c.point;
      pair.normal = sign * c.normal;
    }
  return out;
}

}  // namespace prosector
