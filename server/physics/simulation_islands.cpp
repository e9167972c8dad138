// Phases 4 to 6: islands, their coupled solution, recovery, sleep.

#include <fmt/format.h>

#include <algorithm>

#include "server/physics/contact/flat_elements.h"
#include "server/physics/coupled/recovery.h"
#include "server/physics/coupled/restitution.h"
#include "server/physics/simulation_impl.h"
#include "server/physics/soft/relaxation.h"

namespace prosector {
namespace {

constexpr double opening_speed = 0.25;      // m/s, at most, of rigid bodies that overlap
constexpr double quiet_rigid_speed = 5e-3;  // m/s
constexpr double quiet_rigid_spin = 5e-2;   // rad/s

Mat3 room_inertia(const RigidSetup& setup, const Pose& pose) {
  const Mat3 R = pose.q.toRotationMatrix();
  return R * setup.inertia.asDiagonal() * R.transpose();
}

ContactSide rigid_side(const RigidWorld& world, std::size_t slot, const Vec3& point) {
  ContactSide side;
  side.body = slot;
  if (const auto& to = world.driven_to(slot))
    side.moved = *to * (world.motion(slot).pose.inverse() * point) - point;
  if (!world.dynamic(slot)) return side;
  side.kind = ContactSide::Kind::rigid;
  side.arm = point - world.motion(slot).pose.p;
  return side;
}

bool between_soft(const Contact& c) {
  return c.a.kind == ContactSide::Kind::soft && c.b.kind == ContactSide::Kind::soft && c.a.body != c.b.body;
}

}  // namespace

const std::vector<MixedIsland>& Simulation::Impl::find_islands() {
  std::vector<std::pair<std::size_t, std::size_t>> links;
  std::vector<std::size_t> coupled;
  std::vector<std::optional<std::size_t>> first(soft.size());  // a dynamic body of each soft group's island
  const auto link = [&](std::size_t body, std::size_t slot) {
    std::optional<std::size_t>& known = first[soft_group[body]];
    if (known && *known != slot) links.emplace_back(*known, slot);
    if (!known) known = slot;
    coupled.push_back(slot);
  };
  for (std::size_t i = 0; i < soft.size(); ++i)
    for (const Contact& c : soft_contacts[i])
      if (c.b.kind == ContactSide::Kind::rigid) link(i, c.b.body);
  for (const BladeGrip& grip : blade_grips) link(grip.body, grip.slot);
  for (const Hand& hand : hands) {
    coupled.push_back(hand.slot);
    for (const PadMemory& pad : hand.pads)
      if (world.dynamic(pad.body)) links.emplace_back(hand.slot, pad.body);
    if (!hand.hold) continue;
    if (is_soft(hand.hold->body))
      link(soft_index(hand.hold->body), hand.slot);
    else
      links.emplace_back(hand.slot, hand.hold->body);
  }
  world.find_islands(links, coupled);
  return world.solve(step_h);
}

void Simulation::Impl::gather(const std::vector<MixedIsland>& mixed) {
  islands.clear();
  pads.clear();
  retired.clear();
  std::vector<std::size_t> island_of(world.slots(), 0);
  const auto point_velocity = [&](const ContactSide& side, std::size_t slot) -> Vec3 {
    if (side.kind == ContactSide::Kind::fixed) return side.moved / step_h;
    const RigidMotion motion = world.motion(slot);
    return motion.linear_velocity + motion.angular_velocity.cross(side.arm);
  };
  for (const MixedIsland& m : mixed) {
    Island& island = islands.emplace_back();
    for (const std::size_t slot : m.bodies) {
      island_of[slot] = islands.size() - 1;
      const Hand* hand = hand_at(slot);
      const RigidSetup& setup = hand ? model.hands[hand->side].setup : model.rigid[slot].setup;
      const RigidMotion motion = world.motion(slot);
      const Pose& pose = motion.pose;
      const auto [linear, angular] = world.predicted_velocity(slot, step_h);
      RigidMember member;
      member.slot = slot;
      member.mass = body_mass(slot);
      member.inertia = room_inertia(setup, pose);
      member.predicted << step_h * linear, step_h * angular;
      member.steady << step_h * motion.linear_velocity, step_h * motion.angular_velocity;
      if (hand) member.pull = hand_pull(*hand, model.hands[hand->side], model.scene.hand, pose, step_h);
      island.rigid.push_back(member);
    }
    std::vector<RigidContact> touches = m.contacts;
    for (const std::size_t slot : m.bodies) place_pads(touches, slot);
    for (const RigidContact& rc : touches) {
      Contact c;
      c.a = rigid_side(world, rc.a, rc.point_a);
      c.b = rigid_side(world, rc.b, rc.point_b);
      c.point = (rc.point_a + rc.point_b) / 2;
      c.normal = rc.normal;
      c.gap = std::max(rc.gap, -opening_speed * step_h);
      c.friction = rc.friction;
      c.rebound =
          rebound_speed(rc.restitution, rc.normal.dot(point_velocity(c.a, rc.a) - point_velocity(c.b, rc.b)));
      island.contacts.push_back(c);
      spread_over_pad(rc, islands.size() - 1);
    }
  }
  // A group of soft bodies is in the island of a rigid one that touches or holds one of them, or in its own.
  std::vector<std::optional<std::size_t>> island_of_group(soft.size());
  for (std::size_t i = 0; i < soft.size(); ++i)
    for (const Contact& c : soft_contacts[i])
      if (c.b.kind == ContactSide::Kind::rigid) island_of_group[soft_group[i]] = island_of[c.b.body];
  for (const BladeGrip& grip : blade_grips) island_of_group[soft_group[grip.body]] = island_of[grip.slot];
  for (const Hand& hand : hands)
    if (hand.hold && is_soft(hand.hold->body))
      island_of_group[soft_group[soft_index(hand.hold->body)]] = island_of[hand.slot];
  for (std::size_t i = 0; i < soft.size(); ++i) {
    if (soft[i].asleep) continue;
    std::optional<std::size_t>& at = island_of_group[soft_group[i]];
    if (!at) {
      at = islands.size();
      islands.emplace_back();
    }
    Island& island = islands[*at];
    island.soft.push_back({i, model.soft[i].get(), &soft[i], &equilibrium[i]});
    island.contacts.insert(island.contacts.end(), soft_contacts[i].begin(), soft_contacts[i].end());
  }
  for (const SoftPair& pair : soft_pairs) {
    Island& island = islands[*island_of_group[soft_group[pair.a]]];
    island.contacts.insert(island.contacts.end(), pair.contacts.begin(), pair.contacts.end());
  }
  for (Island& island : islands) watch_flat_elements(island);
  const auto driven = [&](const ContactSide& side) {
    return side.kind == ContactSide::Kind::fixed && world.driven_to(side.body);
  };
  for (Island& island : islands) {
    island.driven = std::any_of(island.contacts.begin(), island.contacts.end(),
                                [&](const Contact& c) { return driven(c.a) || driven(c.b); });
    double heaviest = 0;
    for (const RigidMember& r : island.rigid) heaviest = std::max(heaviest, r.mass);
    for (const SoftMember& s : island.soft) heaviest = std::max(heaviest, s.body->total_mass());
    for (Contact& c : island.contacts)
      if (c.a.kind != ContactSide::Kind::soft && c.bearer == 0)
        c.stiffness = rigid_contact_factor * heaviest / (step_h * step_h);
  }
  for (const BladeGrip& grip : blade_grips) islands[island_of[grip.slot]].ties.push_back(grip.tie);
  for (const Hand& hand : hands) {
    if (!hand.hold) continue;
    Island& island = islands[island_of[hand.slot]];
    const Pose centre = world.motion(hand.slot).pose;
    for (const Hold::Point& p : hand.hold->points) {
      Tie tie;
      const Vec3 at_hand = centre * p.in_hand;
      Vec3 at_body;
      if (is_soft(hand.hold->body)) {
        const std::size_t body = soft_index(hand.hold->body);
        at_body = surfaces[body].positions()[p.vertex];
        tie.b = surface_side(body, p.vertex);
      } else {
        at_body = world.motion(hand.hold->body).pose * p.in_body;
        tie.b = rigid_side(world, hand.hold->body, at_body);
      }
      tie.a = rigid_side(world, hand.slot, at_hand);
      tie.offset = at_hand - at_body;
      tie.stiffness = p.stiffness;
      tie.max_force = p.max_force;
      island.ties.push_back(tie);
    }
  }
}

/// Of solids that meet other soft bodies.
void Simulation::Impl::watch_flat_elements(Island& island) {
  const std::size_t met = island.contacts.size();
  for (const SoftMember& s : island.soft) {
    if (std::none_of(island.contacts.begin(), island.contacts.begin() + static_cast<std::ptrdiff_t>(met),
                     [&](const Contact& c) {
                       return between_soft(c) && (c.a.body == s.index || c.b.body == s.index);
                     }))
      continue;
    const double stiffness = model.scene.contact_stiffness * s.body->desc().youngs_modulus;
    find_flat_elements(s.body->linear_tets(), s.state->motion.x, s.state->motion.v,
                       {s.index, stiffness, step_h}, island.contacts);
  }
}

void Simulation::Impl::solve_islands() {
  last_good.assign(world.slots(), {});
  for (std::size_t slot = 0; slot < world.slots(); ++slot)
    if (world.used(slot)) last_good[slot] = world.motion(slot);
  for (Island& island : islands) {
    const IslandReport solved = stepper.step(island, step_h, model.scene.gravity);
    for (const RigidMember& r : island.rigid)
      if (solved.finite) world.set_velocity(r.slot, r.twist.head<3>() / step_h, r.twist.tail<3>() / step_h);
    for (const SoftMember& s : island.soft) {
      keep(island.contacts, s.index, memories[s.index]);
      BodyReport& row = report.bodies.emplace_back();
      row.body = s.body->desc().name;
      row.newton_iterations = solved.newton_iterations;
      row.solver_iterations = solved.solver_iterations;
      row.residual = solved.residual;
      row.last_step = solved.last_step;
      row.converged = solved.converged && !s.degraded;
      row.substep = s.substeps > 0 ? step_h / s.substeps : 0;
      row.note = s.note;
      if (passed_through[s.index] > 0) {
        row.converged = false;
        row.note = fmt::format("{} pairs of its elements are through each other", passed_through[s.index]);
      }
      if (parted[s.index]) {
        row.converged = false;
        row.note = fmt::format("in {}: led out of it", model.soft[*parted[s.index]]->desc().name);
      }
      row.reset = !solved.finite;
      if (!row.reset) continue;
      row.note = "not finite or out of the room: stopped at its last good state";
      s.state->motion.v.setZero();
      s.state->warm_start.setZero();
      s.state->motion.has_history = false;
    }
    if (!island.soft.empty() && !island.rigid.empty()) ++report.mixed_islands;
  }
  keep_pads();
}

void Simulation::Impl::bounce_rigid() {
  for (Island& island : islands) {
    if (!bounce(island, step_h)) continue;
    for (const RigidMember& r : island.rigid)
      world.set_velocity(r.slot, r.twist.head<3>() / step_h, r.twist.tail<3>() / step_h);
  }
}

void Simulation::Impl::fall_asleep() {
  for (Island& island : islands) {
    bool quiet = true;
    for (SoftMember& s : island.soft) {
      count_quiet_ticks(s);
      if (!has_relaxed(s.body->desc(), s.state->history)) s.state->quiet_ticks = 0;  // it creeps
      quiet = quiet && s.state->quiet_ticks == quiet_ticks_to_sleep && may_sleep(s) && !is_being_led(s.index);
    }
    quiet = quiet && !island.driven;
    for (const RigidMember& r : island.rigid) {
      const RigidMotion motion = world.motion(r.slot);
      quiet = quiet && !hand_at(r.slot) && motion.linear_velocity.norm() < quiet_rigid_speed &&
              motion.angular_velocity.norm() < quiet_rigid_spin;
    }
    if (island.soft.empty()) continue;  // hands and what they hold: Bullet puts the rest to sleep
    for (const RigidMember& r : island.rigid) quiet ? world.sleep(r.slot) : world.stay_awake(r.slot);
    if (!quiet) continue;
    for (const SoftMember& s : island.soft) {
      s.state->asleep = true;
      stored[s.index].reset();
      s.state->motion.v.setZero();
      s.state->warm_start.setZero();
      s.state->motion.has_history = false;
    }
  }
  for (const Island& island : islands)
    for (const SoftMember& s : island.soft) place_surface(s.index);
}

}  // namespace prosector
