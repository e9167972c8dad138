#include "server/physics/mechanics/coupled/island_joints.h"

#include <algorithm>
#include <cmath>

#include "common/assert.h"
#include "server/physics/base/parallel.h"
#include "server/physics/mechanics/contact/pad.h"
#include "server/physics/mechanics/contact/potentials.h"

namespace prosector::coupled {
namespace {

// Tolerances of the contact forces on a body after the last Newton step. The first two are relative to its
// normal forces and its friction limits; the third is a velocity change of the body (m/s).
constexpr double unsettled_normal = 0.1, unsettled_friction = 0.05, unsettled_speed = 1e-3;
constexpr double stick_speed = 5e-4;  // m/s: contacts without slip memory stick below this speed

/// Returns a side's position at the tick's start by the linear map of the unknowns, minus its kinematic
/// motion, m. `start`: positions of the soft nodes, m; `joined`: the same side.
Vec3 start_of(const VecX& start, const contact::ContactSide& side, const JointSide& joined) {
  Vec3 x = -side.moved;
  for (std::size_t k = 0; k < joined.nodes; ++k) x += joined.weight[k] * start.segment<3>(joined.offset[k]);
  return x;
}

/// Calls f(i) for each of n contacts, in parallel chunks.
template <class F>
void for_contacts(std::size_t n, const F& f) {
  constexpr std::size_t at_once = 128;
  parallel_short_chunks(n, at_once, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t c = first; c < last; ++c) f(c);
  });
}

}  // namespace

void IslandJoints::begin(Island& island, const IslandLayout& layout, double h) {
  PROSECTOR_ASSERT(h > 0);
  island_ = &island;
  layout_ = &layout;
  h_ = h;
  start_.resize(layout.rigid_begin);
  for (std::size_t m = 0; m < island.soft.size(); ++m)
    start_.segment(layout.soft[m], 3 * island.soft[m].body->nodes()) = island.soft[m].state->motion.x;
  reach_.begin(island, layout, start_);
  joined_ = reach_.listed();
  contacts_.resize(joined_.size());
  for_contacts(contacts_.size(), [&](std::size_t c) { contacts_[c] = join_contact(joined_[c]); });
  lagged_.assign(contacts_.size(), 0);
  ties_.clear();
  for (const contact::Tie& t : island.ties) ties_.push_back(join(t.a, t.b));
  untaken_ = 1;
}

Joint IslandJoints::join(const contact::ContactSide& a, const contact::ContactSide& b) const {
  Joint joint{layout_->resolve(a), layout_->resolve(b), Vec3::Zero()};
  joint.at_start = start_of(start_, a, joint.a) - start_of(start_, b, joint.b);
  return joint;
}

Joint IslandJoints::join_contact(std::uint32_t contact) const {
  const contact::Contact& c = island_->contacts[contact];
  Joint joint = join(c.a, c.b);
  joint.threshold =
      c.feature != contact::Contact::no_feature || c.bearer > 0 ? slip_threshold : stick_speed * h_;
  return joint;
}

/// Joins the contacts that may act at the unknowns q too. Until now they had no force.
void IslandJoints::cover(const VecX& q) {
  if (!reach_.cover(q)) return;
  const std::vector<std::uint32_t>& listed = reach_.listed();
  fewer_.swap(contacts_);
  fewer_lagged_.swap(lagged_);
  contacts_.resize(listed.size());
  lagged_.assign(listed.size(), 0);
  std::size_t known = 0;
  for (std::size_t c = 0; c < listed.size(); ++c) {
    if (known == joined_.size() || joined_[known] != listed[c]) {
      contacts_[c] = join_contact(listed[c]);
      continue;
    }
    contacts_[c] = fewer_[known];
    lagged_[c] = fewer_lagged_[known++];
  }
  PROSECTOR_ASSERT(known == joined_.size());
  joined_ = listed;
}

/// Returns the slip of friction at the tick's start, m. If the normal force grows, friction keeps its force;
/// if it falls, friction keeps its elastic slip. A spring that stiffens while it is stretched would return
/// more energy than it stored (Thornton and Randall 1988).
Vec3 IslandJoints::held_slip(std::size_t c) const {
  const contact::Contact& held = contact(c);
  if (held.grip.isZero(0)) return held.grip;
  const double before = held.friction * held.gripped, stretch = std::min(1.0, held.grip.norm());
  const double share = lagged_[c] > before ? before / lagged_[c] : 1;
  const double now = 1 - std::sqrt(1 - share * stretch * (2 - stretch));
  const Vec3 across = held.grip - held.normal.dot(held.grip) * held.normal;
  return slip_threshold * now / stretch * across;
}

Vec3 IslandJoints::tie_force(std::size_t t, const VecX& q) const {
  const contact::Tie& tie = island_->ties[t];
  const Vec3 d = tie.offset + displacement(ties_[t], q);
  return contact::BoundedSpring{tie.stiffness, tie.max_force}.secant(d.norm()) * d;
}

void IslandJoints::add_energy(const VecX& q, double& sum) {
  PROSECTOR_ASSERT(q.size() == layout_->size);
  cover(q);
  energies_.resize(contacts_.size());
  for_contacts(contacts_.size(),
               [&](std::size_t c) { energies_[c] = contact_energy(c, displacement(contacts_[c], q)); });
  for (const double energy : energies_) sum += energy;
  for (std::size_t t = 0; t < ties_.size(); ++t) {
    const contact::Tie& tie = island_->ties[t];
    sum += contact::BoundedSpring{tie.stiffness, tie.max_force}.energy(
        (tie.offset + displacement(ties_[t], q)).norm());
  }
}

void IslandJoints::add_gradient(const VecX& q, VecX& g) {
  PROSECTOR_ASSERT(q.size() == layout_->size && g.size() == layout_->size);
  find_forces(q);
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    if (forces_[c].isZero(0)) continue;
    add_force(contacts_[c].a, forces_[c], g);
    add_force(contacts_[c].b, -forces_[c], g);
  }
  for (std::size_t t = 0; t < ties_.size(); ++t) {
    const Vec3 f = tie_force(t, q);
    add_force(ties_[t].a, f, g);
    add_force(ties_[t].b, -f, g);
  }
}

void IslandJoints::find_forces(const VecX& q) {
  cover(q);
  forces_.resize(contacts_.size());
  for_contacts(contacts_.size(),
               [&](std::size_t c) { forces_[c] = contact_force(c, displacement(contacts_[c], q), nullptr); });
}

void IslandJoints::linearise(const VecX& q) {
  PROSECTOR_ASSERT(q.size() == layout_->size);
  cover(q);
  for_contacts(contacts_.size(), [&](std::size_t c) {
    contacts_[c].force = contact_force(c, displacement(contacts_[c], q), &contacts_[c].D);
  });
  for (std::size_t t = 0; t < ties_.size(); ++t) {
    const contact::Tie& tie = island_->ties[t];
    const double d = (tie.offset + displacement(ties_[t], q)).norm();
    ties_[t].D = contact::BoundedSpring{tie.stiffness, tie.max_force}.secant(d) * Mat3::Identity();
  }
}

void IslandJoints::work(const VecX& start, const VecX& q, std::vector<double>& work) {
  PROSECTOR_ASSERT(start.size() == layout_->size && q.size() == layout_->size &&
                   work.size() == island_->soft.size());
  const auto add = [&](const JointSide& side, const Vec3& force) {
    if (side.nodes > 0) work[side.member] += force.dot(moved_by(side, q) - moved_by(side, start));
  };
  cover(q);
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    const Vec3 f = contact_force(c, displacement(contacts_[c], q), nullptr);
    add(contacts_[c].a, -f);
    add(contacts_[c].b, f);
  }
  for (std::size_t t = 0; t < ties_.size(); ++t) {
    const Vec3 f = tie_force(t, q);
    add(ties_[t].a, -f);
    add(ties_[t].b, f);
  }
}

double IslandJoints::normal_force(std::size_t c, const VecX& q) const {
  const contact::Contact& pressed = contact(c);
  const double gap = pressed.gap + pressed.normal.dot(displacement(contacts_[c], q));
  return std::max(0.0, -contact::EvenSpring{pressed.stiffness, pressed.spread}.slope(gap));
}

double IslandJoints::load_of_friction(std::size_t c, const VecX& q) const {
  const std::uint32_t bearer = contact(c).bearer;
  PROSECTOR_ASSERT(bearer <= c && joined_[c - bearer] == joined_[c] - bearer);
  return bearer > 0 ? normal_force(c - bearer, q) / contact::patch_points : normal_force(c, q);
}

void IslandJoints::lag_friction(const VecX& q) {
  cover(q);
  for_contacts(contacts_.size(), [&](std::size_t c) {
    lagged_[c] = contact(c).friction * load_of_friction(c, q);
    contacts_[c].held = held_slip(c);
  });
}

void IslandJoints::take(double length, const VecX& step) {
  PROSECTOR_ASSERT(length > 0 && length <= 1 && step.size() == layout_->size);
  untaken_ *= 1 - length;
  for_contacts(contacts_.size(), [&](std::size_t c) {
    Joint& joint = contacts_[c];
    Vec3 force = joint.force;
    if (!joint.D.isZero(0)) force += joint.D * (moved_by(joint.a, step) - moved_by(joint.b, step));
    joint.exchanged += length * (force - joint.exchanged);
    joint.foreseen = joint.force + length * (force - joint.force);
  });
}

void IslandJoints::take_balanced() {
  untaken_ = 0;
  for (Joint& joint : contacts_) joint.exchanged = joint.force;
}

void IslandJoints::add_load(const JointSide& side, const Load& load) {
  if (side.nodes == 0 && side.rigid < 0) return;
  Load& sum = side.nodes > 0 ? soft_loads_[side.member] : rigid_loads_[layout_->rigid_member(side)];
  sum.normal += load.normal;
  sum.normal_off += load.normal_off;
  sum.friction += load.friction;
  sum.friction_off += load.friction_off;
}

bool IslandJoints::unsettled(const VecX& q) {
  PROSECTOR_ASSERT(q.size() == layout_->size && lagged_.size() == contacts_.size());
  soft_loads_.assign(island_->soft.size(), {});
  rigid_loads_.assign(island_->rigid.size(), {});
  find_forces(q);
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    const Joint& joint = contacts_[c];
    const Vec3& force = forces_[c];
    const Vec3 off = force - joint.foreseen;
    if (force.isZero(0) && off.isZero(0) && lagged_[c] == 0) continue;
    const Vec3& n = contact(c).normal;
    const double along = n.dot(off);
    const Load load = {-n.dot(force), std::abs(along), lagged_[c], (off - along * n).norm()};
    add_load(joint.a, load);
    add_load(joint.b, load);
  }
  const auto far_off = [&](const Load& load, double mass) {
    const double little = unsettled_speed * mass / h_;
    return load.normal_off > unsettled_normal * load.normal + little ||
           load.friction_off > unsettled_friction * load.friction + little;
  };
  for (std::size_t m = 0; m < soft_loads_.size(); ++m)
    if (far_off(soft_loads_[m], island_->soft[m].body->total_mass())) return true;
  for (std::size_t m = 0; m < rigid_loads_.size(); ++m)
    if (far_off(rigid_loads_[m], island_->rigid[m].mass)) return true;
  return false;
}

void IslandJoints::write_joint_forces(const VecX& q, bool all_held) {
  PROSECTOR_ASSERT(q.size() == layout_->size && island_->ties.size() == ties_.size());
  cover(q);
  const double taken = all_held && untaken_ < 1 ? 1 - untaken_ : 1;
  for (contact::Contact& contact : island_->contacts) contact.clear_results();
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    contact::Contact& contact = island_->contacts[joined_[c]];
    contact.force = normal_force(c, q);
    contact.exchanged = -contacts_[c].exchanged / taken;
    if (!(lagged_[c] > 0)) continue;
    const Vec3 u = displacement(contacts_[c], q);
    const Vec3 slip = u - contact.normal.dot(u) * contact.normal + contacts_[c].held;
    const double length = slip.norm();
    contact.grip_after = slip / std::max(length, contacts_[c].threshold);
  }
  for (std::size_t t = 0; t < ties_.size(); ++t) island_->ties[t].force = -tie_force(t, q);
}

double IslandJoints::contact_energy(std::size_t c, const Vec3& u) const {
  const contact::Contact& pressed = contact(c);
  const double along = pressed.normal.dot(u);
  const double slip = (u - along * pressed.normal + contacts_[c].held).norm();
  return contact::EvenSpring{pressed.stiffness, pressed.spread}.energy(pressed.gap + along) +
         lagged_[c] * contact::FrictionNorm{contacts_[c].threshold}.energy(slip);
}

Vec3 IslandJoints::contact_force(std::size_t c, const Vec3& u, Mat3* D) const {
  const contact::Contact& pressed = contact(c);
  const Vec3& n = pressed.normal;
  const double along = n.dot(u), gap = pressed.gap + along;
  const contact::EvenSpring area{pressed.stiffness, pressed.spread};
  const Vec3 slip = u - along * n + contacts_[c].held;
  const double drag =
      lagged_[c] > 0 ? lagged_[c] * contact::FrictionNorm{contacts_[c].threshold}.secant(slip.norm()) : 0;
  if (D) {
    const Mat3 nn = n * n.transpose();
    *D = area.stiffness(gap) * nn + drag * (Mat3::Identity() - nn);
  }
  return area.slope(gap) * n + drag * slip;
}

}  // namespace prosector::coupled
