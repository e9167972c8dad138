#include "server/physics/coupled/island_system.h"

#include <algorithm>

#include "server/physics/contact/pad.h"
#include "server/physics/coupled/lever.h"
#include "server/physics/coupled/potentials.h"
#include "server/physics/parallel.h"
#include "server/physics/soft/implicit_stepper.h"
#include "server/physics/soft/incremental_potential.h"

namespace prosector {
namespace {

constexpr std::size_t nodes_per_chunk = 512;
// What a body's contacts may be off by after the last Newton step: of their normal forces, of the friction
// that they allow, and (m/s) what that gives the body.
constexpr double unsettled_normal = 0.1, unsettled_friction = 0.05, unsettled_speed = 1e-3;
constexpr double stick_speed = 5e-4;  // m/s: what has no slip to remember sticks below it

Mat6 inertia_block(const RigidMember& body, double h) {
  Mat6 m = Mat6::Zero();
  m.topLeftCorner<3, 3>() = body.mass / (h * h) * Mat3::Identity();
  m.bottomRightCorner<3, 3>() = body.inertia / (h * h);
  return m;
}

}  // namespace

void IslandSystem::begin(Island& island, double h) {
  island_ = &island;
  h_ = h;
  size_ = 0;
  soft_offset_.clear();
  for (const SoftMember& m : island.soft) {
    soft_offset_.push_back(size_);
    size_ += 3 * m.body->nodes();
  }
  rigid_begin_ = size_;
  size_ += 6 * static_cast<Eigen::Index>(island.rigid.size());
  contacts_.clear();
  ties_.clear();
  for (const Contact& c : island.contacts) {
    contacts_.push_back(join(c.a, c.b));
    contacts_.back().threshold =
        c.feature != Contact::no_feature || c.bearer > 0 ? slip_threshold : stick_speed * h;
  }
  for (const Tie& t : island.ties) ties_.push_back(join(t.a, t.b));
  join_rigid();
  stiff_.reserve(contacts_.size() + ties_.size());
  lagged_.assign(contacts_.size(), 0);
  untaken_ = 1;
  node_blocks_.resize(static_cast<std::size_t>(rigid_begin_ / 3));
  node_inverse_.resize(node_blocks_.size());
  rigid_blocks_.resize(island.rigid.size());
  rigid_sums_.resize(island.rigid.size());
  rigid_factors_.resize(island.rigid.size());
}

IslandSystem::Side IslandSystem::resolve(const ContactSide& side) const {
  Side out;
  if (side.kind == ContactSide::Kind::soft) {
    std::size_t m = 0;
    while (island_->soft[m].index != side.body) ++m;
    out.member = m;
    out.nodes = side.nodes;
    out.weight = side.weight;
    for (std::size_t k = 0; k < side.nodes; ++k)
      out.offset[k] = soft_offset_[m] + 3 * static_cast<Eigen::Index>(side.node[k]);
  } else if (side.kind == ContactSide::Kind::rigid) {
    std::size_t m = 0;
    while (island_->rigid[m].slot != side.body) ++m;
    out.rigid = rigid_offset(m);
    out.arm = side.arm;
  }
  return out;
}

IslandSystem::Joint IslandSystem::join(const ContactSide& a, const ContactSide& b) const {
  const auto start = [&](const ContactSide& side) {
    Vec3 x = -side.moved;
    if (side.kind != ContactSide::Kind::soft) return x;
    for (const SoftMember& m : island_->soft)
      if (m.index == side.body)
        for (std::size_t k = 0; k < side.nodes; ++k)
          x += side.weight[k] * m.state->motion.x.segment<3>(3 * static_cast<Eigen::Index>(side.node[k]));
    return x;
  };
  return {resolve(a), resolve(b), start(a) - start(b)};
}

/// Where the normal force grows, friction keeps its force, and where it falls, its stretch: a spring that
/// stiffens while it is stretched would give back more than it got (Thornton and Randall 1988).
Vec3 IslandSystem::held_slip(std::size_t c) const {
  const Contact& contact = island_->contacts[c];
  if (contact.grip.isZero(0)) return contact.grip;
  const double before = contact.friction * contact.gripped, stretch = std::min(1.0, contact.grip.norm());
  const double share = lagged_[c] > before ? before / lagged_[c] : 1;
  const double now = 1 - std::sqrt(1 - share * stretch * (2 - stretch));
  const Vec3 across = contact.grip - contact.normal.dot(contact.grip) * contact.normal;
  return slip_threshold * now / stretch * across;
}

Vec3 IslandSystem::read(const Side& side, const VecX& q) {
  Vec3 u = Vec3::Zero();
  for (std::size_t k = 0; k < side.nodes; ++k) u += side.weight[k] * q.segment<3>(side.offset[k]);
  if (side.rigid >= 0) {
    const Vec3 rotation = q.segment<3>(side.rigid + 3);
    u += q.segment<3>(side.rigid) + rotation.cross(side.arm);
  }
  return u;
}

void IslandSystem::add(const Side& side, const Vec3& f, VecX& out) {
  for (std::size_t k = 0; k < side.nodes; ++k) out.segment<3>(side.offset[k]) += side.weight[k] * f;
  if (side.rigid >= 0) {
    out.segment<3>(side.rigid) += f;
    out.segment<3>(side.rigid + 3) += side.arm.cross(f);
  }
}

void IslandSystem::initial_guess(VecX& q) const {
  q.resize(size_);
  for (std::size_t m = 0; m < island_->soft.size(); ++m)
    island_->soft[m].body->stepper().initial_guess(
        h_, *island_->soft[m].state, q.segment(soft_offset_[m], 3 * island_->soft[m].body->nodes()));
  for (std::size_t m = 0; m < island_->rigid.size(); ++m)
    q.segment<6>(rigid_offset(m)) = island_->rigid[m].steady;
}

void IslandSystem::start(VecX& q) const {
  q.resize(size_);
  for (std::size_t m = 0; m < island_->soft.size(); ++m)
    q.segment(soft_offset_[m], 3 * island_->soft[m].body->nodes()) = island_->soft[m].state->motion.x;
  for (std::size_t m = 0; m < island_->rigid.size(); ++m)
    q.segment<6>(rigid_offset(m)) = island_->rigid[m].predicted;
}

void IslandSystem::joint_work(const VecX& start, const VecX& q, std::vector<double>& work) const {
  const auto add = [&](const Side& side, const Vec3& force) {
    if (side.nodes > 0) work[side.member] += force.dot(read(side, q) - read(side, start));
  };
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    const Vec3 f = contact_force(c, displacement(contacts_[c], q), nullptr);
    add(contacts_[c].a, -f);
    add(contacts_[c].b, f);
  }
  for (std::size_t t = 0; t < ties_.size(); ++t) {
    const Tie& tie = island_->ties[t];
    const Vec3 d = tie.offset + displacement(ties_[t], q);
    const Vec3 f = BoundedSpring{tie.stiffness, tie.max_force}.secant(d.norm()) * d;
    add(ties_[t].a, -f);
    add(ties_[t].b, f);
  }
}

double IslandSystem::normal_force(std::size_t c, const VecX& q) const {
  const Contact& contact = island_->contacts[c];
  const double gap = contact.gap + contact.normal.dot(displacement(contacts_[c], q));
  return contact.stiffness * std::max(0.0, -gap);
}

double IslandSystem::load_of_friction(std::size_t c, const VecX& q) const {
  const std::uint32_t bearer = island_->contacts[c].bearer;
  return bearer > 0 ? normal_force(c - bearer, q) / patch_points : normal_force(c, q);
}

void IslandSystem::lag_friction(const VecX& q) {
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    lagged_[c] = island_->contacts[c].friction * load_of_friction(c, q);
    contacts_[c].held = held_slip(c);
  }
}

void IslandSystem::take(double length, const VecX& step) {
  untaken_ *= 1 - length;
  for (Joint& joint : contacts_) {
    Vec3 force = joint.force;
    if (!joint.D.isZero(0)) force += joint.D * (read(joint.a, step) - read(joint.b, step));
    joint.exchanged += length * (force - joint.exchanged);
    joint.foreseen = joint.force + length * (force - joint.force);
  }
}

void IslandSystem::take_balanced() {
  untaken_ = 0;
  for (Joint& joint : contacts_) joint.exchanged = joint.force;
}

bool IslandSystem::unsettled(const VecX& q) {
  soft_loads_.assign(island_->soft.size(), {});
  rigid_loads_.assign(island_->rigid.size(), {});
  const auto add = [&](const Side& side, const Load& load) {
    if (side.nodes == 0 && side.rigid < 0) return;
    Load& sum = side.nodes > 0 ? soft_loads_[side.member] : rigid_loads_[rigid_member(side)];
    sum.normal += load.normal;
    sum.normal_off += load.normal_off;
    sum.friction += load.friction;
    sum.friction_off += load.friction_off;
  };
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    const Joint& joint = contacts_[c];
    const Vec3& n = island_->contacts[c].normal;
    const Vec3 force = contact_force(c, displacement(joint, q), nullptr), off = force - joint.foreseen;
    const double along = n.dot(off);
    const Load load = {-n.dot(force), std::abs(along), lagged_[c], (off - along * n).norm()};
    add(joint.a, load);
    add(joint.b, load);
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

void IslandSystem::tell_contacts(const VecX& q, bool all_held) {
  const double taken = all_held && untaken_ < 1 ? 1 - untaken_ : 1;
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    Contact& contact = island_->contacts[c];
    contact.force = normal_force(c, q);
    contact.exchanged = -contacts_[c].exchanged / taken;
    contact.grip_after.setZero();
    if (!(lagged_[c] > 0)) continue;
    const Vec3 u = displacement(contacts_[c], q);
    const Vec3 slip = u - contact.normal.dot(u) * contact.normal + contacts_[c].held;
    const double length = slip.norm();
    contact.grip_after = slip / std::max(length, contacts_[c].threshold);
  }
}

double IslandSystem::contact_energy(std::size_t c, const Vec3& u) const {
  const Contact& contact = island_->contacts[c];
  const double along = contact.normal.dot(u), gap = std::min(0.0, contact.gap + along);
  const double slip = (u - along * contact.normal + contacts_[c].held).norm();
  return contact.stiffness * gap * gap / 2 + lagged_[c] * FrictionNorm{contacts_[c].threshold}.energy(slip);
}

Vec3 IslandSystem::contact_force(std::size_t c, const Vec3& u, Mat3* D) const {
  const Contact& contact = island_->contacts[c];
  const Vec3& n = contact.normal;
  const double along = n.dot(u), gap = std::min(0.0, contact.gap + along);
  const Vec3 slip = u - along * n + contacts_[c].held;
  const double drag =
      lagged_[c] > 0 ? lagged_[c] * FrictionNorm{contacts_[c].threshold}.secant(slip.norm()) : 0;
  if (D) {
    const Mat3 nn = n * n.transpose();
    *D = (gap < 0 ? contact.stiffness : 0.0) * nn + drag * (Mat3::Identity() - nn);
  }
  return contact.stiffness * gap * n + drag * slip;
}

double IslandSystem::energy(const VecX& q) {
  soft_energy_ = 0;
  for (std::size_t m = 0; m < island_->soft.size(); ++m)
    soft_energy_ += island_->soft[m].body->potential().energy(
        q.segment(soft_offset_[m], 3 * island_->soft[m].body->nodes()));
  return soft_energy_ + joint_energy(q);
}

double IslandSystem::stored_in_tissue(const VecX& q) const {
  double sum = soft_energy_;
  for (std::size_t m = 0; m < island_->soft.size(); ++m)
    sum -= island_->soft[m].body->potential().inertia_energy(
        q.segment(soft_offset_[m], 3 * island_->soft[m].body->nodes()));
  return sum;
}

double IslandSystem::stored_in_joints(const VecX& q) const {
  double sum = joint_energy(q);
  for (std::size_t m = 0; m < island_->rigid.size(); ++m)
    sum -= rigid_inertia(island_->rigid[m], q.segment<6>(rigid_offset(m)));
  return sum;
}

double IslandSystem::rigid_inertia(const RigidMember& body, const Vec6& twist) const {
  const Vec6 d = twist - body.predicted;
  return (body.mass * d.head<3>().squaredNorm() + d.tail<3>().dot(body.inertia * d.tail<3>())) /
         (2 * h_ * h_);
}

double IslandSystem::joint_energy(const VecX& q) const {
  double sum = 0;
  for (std::size_t m = 0; m < island_->rigid.size(); ++m) {
    const RigidMember& body = island_->rigid[m];
    const Vec6 twist = q.segment<6>(rigid_offset(m));
    sum += rigid_inertia(body, twist);
    if (body.pull) {
      const Pull& pull = *body.pull;
      sum +=
          BoundedSpring{pull.stiffness, pull.max_force}.energy((twist.head<3>() - pull.translation).norm());
      sum += BoundedSpring{pull.angular_stiffness, pull.max_moment}.energy(
          (twist.tail<3>() - pull.rotation).norm());
    }
  }
  for (std::size_t c = 0; c < contacts_.size(); ++c) sum += contact_energy(c, displacement(contacts_[c], q));
  for (std::size_t t = 0; t < ties_.size(); ++t) {
    const Tie& tie = island_->ties[t];
    sum +=
        BoundedSpring{tie.stiffness, tie.max_force}.energy((tie.offset + displacement(ties_[t], q)).norm());
  }
  return sum;
}

void IslandSystem::linearise(const VecX& q) {
  for (std::size_t m = 0; m < island_->soft.size(); ++m)
    island_->soft[m].body->potential().linearise(
        q.segment(soft_offset_[m], 3 * island_->soft[m].body->nodes()));
}

void IslandSystem::gradient(const VecX& q, VecX& g) {
  g.resize(size_);
  for (std::size_t m = 0; m < island_->soft.size(); ++m) {
    const Eigen::Index n = 3 * island_->soft[m].body->nodes();
    island_->soft[m].body->potential().gradient(q.segment(soft_offset_[m], n), g.segment(soft_offset_[m], n));
  }
  for (std::size_t m = 0; m < island_->rigid.size(); ++m) {
    const RigidMember& body = island_->rigid[m];
    const Vec6 twist = q.segment<6>(rigid_offset(m)), d = twist - body.predicted;
    auto out = g.segment<6>(rigid_offset(m));
    out.head<3>() = body.mass / (h_ * h_) * d.head<3>();
    out.tail<3>() = body.inertia * d.tail<3>() / (h_ * h_);
    if (body.pull) {
      const Pull& pull = *body.pull;
      const Vec3 e = twist.head<3>() - pull.translation, r = twist.tail<3>() - pull.rotation;
      out.head<3>() += BoundedSpring{pull.stiffness, pull.max_force}.secant(e.norm()) * e;
      out.tail<3>() += BoundedSpring{pull.angular_stiffness, pull.max_moment}.secant(r.norm()) * r;
    }
  }
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    const Vec3 f = contact_force(c, displacement(contacts_[c], q), nullptr);
    add(contacts_[c].a, f, g);
    add(contacts_[c].b, -f, g);
  }
  for (std::size_t t = 0; t < ties_.size(); ++t) {
    const Tie& tie = island_->ties[t];
    const Vec3 d = tie.offset + displacement(ties_[t], q);
    const Vec3 f = BoundedSpring{tie.stiffness, tie.max_force}.secant(d.norm()) * d;
    add(ties_[t].a, f, g);
    add(ties_[t].b, -f, g);
  }
}

void IslandSystem::add_block(const Side& side, const Mat3& D) {
  for (std::size_t k = 0; k < side.nodes; ++k)
    node_blocks_[static_cast<std::size_t>(side.offset[k] / 3)] += side.weight[k] * side.weight[k] * D;
  if (side.rigid >= 0) {
    const Mat36 J = lever(side.arm);
    rigid_sums_[rigid_member(side)] += J.transpose() * D * J;
  }
}

void IslandSystem::join_rigid() {
  joined_ = false;
  rigid_pairs_.clear();
  for (const auto* joints : {&contacts_, &ties_})
    for (const Joint& joint : *joints)
      if (joint.a.rigid >= 0 && joint.b.rigid >= 0)
        rigid_pairs_.push_back(std::minmax({rigid_member(joint.a), rigid_member(joint.b)}));
  if (!rigid_pairs_.empty()) rigid_joined_.begin(island_->rigid.size(), rigid_pairs_);
}

void IslandSystem::factor_rigid() {
  condensed_ = rigid_begin_ > 0 && rigid_begin_ < size_;
  for (std::size_t m = 0; m < rigid_sums_.size(); ++m) rigid_factors_[m].compute(rigid_sums_[m]);
  if (rigid_pairs_.empty()) return;
  rigid_joined_.set_zero();
  for (std::size_t m = 0; m < rigid_sums_.size(); ++m) rigid_joined_.add(m, rigid_sums_[m]);
  for (const Joint* joint : stiff_) {
    if (joint->a.rigid < 0 || joint->b.rigid < 0) continue;
    const bool in_order = joint->a.rigid < joint->b.rigid;
    const Side &first = in_order ? joint->a : joint->b, &second = in_order ? joint->b : joint->a;
    rigid_joined_.add(rigid_member(first), rigid_member(second),
                      -lever(first.arm).transpose() * joint->D * lever(second.arm));
  }
  joined_ = rigid_joined_.factor();
  condensed_ = condensed_ && joined_;
}

void IslandSystem::solve_rigid(const VecX& r, VecX& z) const {
  const auto size = size_ - rigid_begin_;
  if (joined_) {
    rigid_joined_.solve(r.tail(size), z.tail(size));
    return;
  }
  for (std::size_t m = 0; m < rigid_factors_.size(); ++m)
    z.segment<6>(rigid_offset(m)) = rigid_factors_[m].solve(r.segment<6>(rigid_offset(m)));
}

void IslandSystem::precondition_rigid(const VecX& r, VecX& z) const {
  if (condensed_)
    z.tail(size_ - rigid_begin_).setZero();
  else
    solve_rigid(r, z);
}

/// Takes the rigid part f of a vector, the forces on the rigid bodies, to −A_sr·A_rr⁻¹·f on the soft nodes.
void IslandSystem::pass_through_rigid(VecX& Hp) const {
  rigid_work_.setZero(size_);
  solve_rigid(Hp, rigid_work_);
  for (const Joint* joint : stiff_) {
    if ((joint->a.rigid < 0 && joint->b.rigid < 0) || (joint->a.nodes == 0 && joint->b.nodes == 0)) continue;
    const Vec3 f = joint->D * (read(joint->b, rigid_work_) - read(joint->a, rigid_work_));
    add_soft(joint->a, f, Hp);
    add_soft(joint->b, -f, Hp);
  }
  Hp.tail(size_ - rigid_begin_).setZero();
}

void IslandSystem::condense(VecX& g) const {
  if (condensed_) pass_through_rigid(g);
}

void IslandSystem::expand(const VecX& g, const VecX& solved, VecX& step) const {
  step = solved;
  if (!condensed_) return;
  rest_ = g;  // less what the soft nodes' step does to the rigid bodies
  for (const Joint* joint : stiff_) {
    if (joint->a.nodes == 0 && joint->b.nodes == 0) continue;
    const Vec3 f = joint->D * (read(joint->a, step) - read(joint->b, step));
    add(joint->a, -f, rest_);
    add(joint->b, f, rest_);
  }
  solve_rigid(rest_, step);
}

void IslandSystem::add_soft(const Side& side, const Vec3& f, VecX& out) const {
  for (std::size_t k = 0; k < side.nodes; ++k) out.segment<3>(side.offset[k]) += side.weight[k] * f;
}

bool IslandSystem::assemble(const VecX& q, bool exact) {
  bool kept = false;
  for (std::size_t m = 0; m < island_->soft.size(); ++m) {
    SoftBody& body = *island_->soft[m].body;
    const auto x = q.segment(soft_offset_[m], 3 * body.nodes());
    if (exact)
      body.potential().assemble(x);
    else
      kept = body.potential().assemble_roughly(x) || kept;
    body.potential().diagonal(
        std::span(node_blocks_)
            .subspan(static_cast<std::size_t>(soft_offset_[m] / 3), static_cast<std::size_t>(body.nodes())));
  }
  for (std::size_t m = 0; m < island_->rigid.size(); ++m) {
    const RigidMember& body = island_->rigid[m];
    Mat6& block = rigid_blocks_[m] = inertia_block(body, h_);
    if (body.pull) {
      const Pull& pull = *body.pull;
      const Vec6 twist = q.segment<6>(rigid_offset(m));
      const double e = (twist.head<3>() - pull.translation).norm(),
                   r = (twist.tail<3>() - pull.rotation).norm();
      block.diagonal().head<3>().array() += BoundedSpring{pull.stiffness, pull.max_force}.secant(e);
      block.diagonal().tail<3>().array() += BoundedSpring{pull.angular_stiffness, pull.max_moment}.secant(r);
    }
    rigid_sums_[m] = block;
  }
  for (std::size_t c = 0; c < contacts_.size(); ++c)
    contacts_[c].force = contact_force(c, displacement(contacts_[c], q), &contacts_[c].D);
  for (std::size_t t = 0; t < ties_.size(); ++t) {
    const Tie& tie = island_->ties[t];
    const double d = (tie.offset + displacement(ties_[t], q)).norm();
    ties_[t].D = BoundedSpring{tie.stiffness, tie.max_force}.secant(d) * Mat3::Identity();
  }
  stiff_.clear();
  for (const auto* joints : {&contacts_, &ties_})
    for (const Joint& joint : *joints) {
      if (joint.D.isZero(0)) continue;
      stiff_.push_back(&joint);
      add_block(joint.a, joint.D);
      add_block(joint.b, joint.D);
    }
  parallel_chunks(node_blocks_.size(), nodes_per_chunk,
                  [&](std::size_t first, std::size_t last, std::size_t) {
                    for (std::size_t i = first; i < last; ++i) node_inverse_[i] = node_blocks_[i].inverse();
                  });
  factor_rigid();
  return kept;
}

void IslandSystem::multiply(const VecX& p, VecX& Hp) const {
  Hp.resize(size_);
  for (std::size_t m = 0; m < island_->soft.size(); ++m)
    island_->soft[m].body->potential().multiply(p.data() + soft_offset_[m], Hp.data() + soft_offset_[m]);
  for (std::size_t m = 0; m < island_->rigid.size(); ++m)
    Hp.segment<6>(rigid_offset(m)) = rigid_blocks_[m] * p.segment<6>(rigid_offset(m));
  for (const Joint* joint : stiff_) {
    const Vec3 f = joint->D * (read(joint->a, p) - read(joint->b, p));
    add(joint->a, f, Hp);
    add(joint->b, -f, Hp);
  }
  if (condensed_) pass_through_rigid(Hp);
}

void IslandSystem::block_jacobi(const VecX& r, VecX& z) const {
  z.resize(size_);
  parallel_chunks(node_inverse_.size(), nodes_per_chunk,
                  [&](std::size_t first, std::size_t last, std::size_t) {
                    for (std::size_t i = first; i < last; ++i) {
                      const auto at = 3 * static_cast<Eigen::Index>(i);
                      z.segment<3>(at) = node_inverse_[i] * r.segment<3>(at);
                    }
                  });
  precondition_rigid(r, z);
}

void IslandSystem::multigrid(const VecX& r, VecX& z) const {
  z.resize(size_);
  for (std::size_t m = 0; m < island_->soft.size(); ++m) {
    SoftBody& body = *island_->soft[m].body;
    const auto first = static_cast<std::size_t>(soft_offset_[m] / 3),
               count = static_cast<std::size_t>(body.nodes());
    body.potential().multigrid_solve(std::span(node_blocks_).subspan(first, count),
                                     std::span(node_inverse_).subspan(first, count),
                                     r.data() + soft_offset_[m], z.data() + soft_offset_[m]);
  }
  precondition_rigid(r, z);
}

void IslandSystem::elastic_factor(const VecX& r, VecX& z) const {
  z.resize(size_);
  for (std::size_t m = 0; m < island_->soft.size(); ++m)
    island_->soft[m].body->potential().factor_solve(r.data() + soft_offset_[m], z.data() + soft_offset_[m]);
  precondition_rigid(r, z);
}

}  // namespace prosector
