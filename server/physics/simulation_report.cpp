// Phase 8: what the step did, and where the hands are.

#include <algorithm>

#include "server/physics/contact/flat_elements.h"
#include "server/physics/simulation_impl.h"

namespace prosector {
namespace {

constexpr double latest_impact = 1;  // s: what would be met later is not told

/// Which body a contact's side belongs to.
BodyId body_of(const ContactSide& side, std::size_t rigid_count) {
  return static_cast<BodyId>(side.kind == ContactSide::Kind::soft ? rigid_count + side.body : side.body);
}

/// m/s, at the tick's end.
Vec3 velocity_of(const ContactSide& side, const RigidWorld& world, const std::vector<SoftBodyState>& soft,
                 double h) {
  if (side.kind == ContactSide::Kind::fixed) return side.moved / h;
  if (side.kind == ContactSide::Kind::rigid) {
    const RigidMotion motion = world.motion(side.body);
    return motion.linear_velocity + motion.angular_velocity.cross(side.arm);
  }
  Vec3 v = Vec3::Zero();
  for (std::size_t k = 0; k < side.nodes; ++k)
    v += side.weight[k] * soft[side.body].motion.v.segment<3>(3 * static_cast<Eigen::Index>(side.node[k]));
  return v;
}

}  // namespace

void Simulation::Impl::describe() {
  report.time = time;
  for (const Island& island : islands)
    report.contacts += static_cast<std::uint32_t>(
        std::count_if(island.contacts.begin(), island.contacts.end(),
                      [](const Contact& c) { return c.bearer == 0 && !within_element(c); }));
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
    ++(soft[i].asleep ? report.asleep_bodies : report.awake_bodies);
    report.kinetic_energy += model.soft[i]->kinetic_energy(soft[i]);
    if (!soft[i].asleep || !stored[i]) stored[i] = stored_in(i);
    report.elastic_energy += stored[i]->elastic;
    report.potential_energy += stored[i]->weight;
  }
  describe_hands();
}

Simulation::Impl::StoredEnergy Simulation::Impl::stored_in(std::size_t i) const {
  SoftBody& body = *model.soft[i];
  StoredEnergy out;
  out.elastic = body.in_force(soft[i]).elastic_energy(soft[i].motion.x);
  if (!body.falls()) return out;
  for (Eigen::Index n = 0; n < body.nodes(); ++n)
    out.weight -= body.node_mass()[n] * model.scene.gravity.dot(soft[i].motion.x.segment<3>(3 * n));
  return out;
}

std::vector<Exchange> Simulation::Impl::exchanges() const {
  std::vector<Exchange> out = earlier_exchanges;
  std::vector<double> strongest(out.size(), 0);      // N, of each
  const auto named = [&](const ContactSide& side) {  // not a hand
    return side.kind == ContactSide::Kind::soft || side.body < model.rigid.size();
  };
  // A pair's contacts come one after the other, but of two soft bodies in either order.
  const auto at = [&](BodyId a, BodyId b) {
    const auto same = [&](const Exchange& e) { return (e.a == a && e.b == b) || (e.a == b && e.b == a); };
    const auto last = std::find_if(out.rbegin(), out.rend(), same);
    if (last != out.rend()) return static_cast<std::size_t>(out.rend() - last) - 1;
    out.push_back({a, b});
    strongest.push_back(0);
    return out.size() - 1;
  };
  for (const Island& island : islands)
    for (const Contact& c : island.contacts) {
      if (!(c.force > 0 || !c.exchanged.isZero(0)) || !named(c.a) || !named(c.b) || within_element(c))
        continue;
      const BodyId a = body_of(c.a, model.rigid.size()), b = body_of(c.b, model.rigid.size());
      const std::size_t i = at(a, b);
      Exchange& pair = out[i];
      const double sign = pair.a == a ? 1 : -1;
      ++pair.points;
      pair.impulse += sign * step_h * c.exchanged;
      pair.normal_impulse += step_h * c.normal.dot(c.exchanged);
      pair.depth = std::max(pair.depth, -(c.gap + c.rest));
      if (c.force <= strongest[i]) continue;
      strongest[i] = c.force;
      pair.point = c.point;
      pair.normal = sign * c.normal;
    }
  return out;
}

/// Of what presses, impulses and forces sum up, and the rest is of the strongest; where nothing does, it is
/// of what is met first if all goes on as it does at the tick's end.
void Simulation::Impl::note(ContactSample& sample, const Contact& c, bool hand_is_b,
                            double& strongest) const {
  if (c.bearer > 0) {  // friction of a contact that is told by itself
    sample.force += hand_is_b ? c.exchanged : Vec3(-c.exchanged);
    return;
  }
  const double gap = c.gap + c.rest;
  if (c.force > 0) {
    sample.impulse += c.force * model.h;
    sample.force += hand_is_b ? c.exchanged : Vec3(-c.exchanged);
    if (c.force <= strongest) return;
    strongest = c.force;
    sample.touching = true;
    sample.depth = c.force / c.stiffness - c.rest;
    sample.impact = gap > 0 ? model.h * gap / (gap + sample.depth) : 0;
  } else {
    const double closing =
        -c.normal.dot(velocity_of(c.a, world, soft, step_h) - velocity_of(c.b, world, soft, step_h));
    if (sample.touching || gap <= 0 || gap > latest_impact * closing) return;
    const double impact = gap / closing;
    if (sample.impact >= 0 && impact >= sample.impact) return;
    sample.depth = closing * model.h - gap;
    sample.impact = impact;
  }
  const ContactSide& met = hand_is_b ? c.a : c.b;
  sample.body = body_of(met, model.rigid.size());
  sample.point = c.point;
  sample.normal = hand_is_b ? Vec3(-c.normal) : c.normal;
  sample.local_point.setZero();
  if (met.kind == ContactSide::Kind::soft)
    for (std::size_t k = 0; k < met.nodes; ++k)
      sample.local_point +=
          met.weight[k] * model.soft[met.body]->rest().segment<3>(3 * static_cast<Eigen::Index>(met.node[k]));
  else if (met.body < model.rigid.size())
    sample.local_point = model.rigid[met.body].center * (colliders[met.body].pose.inverse() * c.point);
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
            note(sample, c, hand_is_b, strongest);
        }
    if (hand.hold) add_hold(sample, hand);
  }
}

}  // namespace prosector
