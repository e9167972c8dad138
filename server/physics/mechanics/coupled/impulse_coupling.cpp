#include "server/physics/mechanics/coupled/impulse_coupling.h"

#include <Eigen/LU>
#include <algorithm>
#include <optional>
#include <vector>

#include "common/assert.h"
#include "server/physics/mechanics/coupled/lever.h"
#include "server/physics/mechanics/coupled/tied_response.h"
#include "server/physics/mechanics/soft/integrators/substepper.h"

namespace prosector::coupled {
namespace {

constexpr int sweeps = 4;  // Gauss-Seidel sweeps over all contacts and ties, per substep
// m/s: limit of the predicted velocity change, which can be extreme for single nodes of stiff meshes.
constexpr double most_foreseen = 2;

struct Rigid {
  Vec3 v, w;                                         // m/s, rad/s
  Vec3 moved = Vec3::Zero(), turned = Vec3::Zero();  // since the tick's start: m, rad
  double inverse_mass;
  Mat3 inverse_inertia;
  std::optional<std::size_t> held;  // index among the joined bodies (held_together.h); for these bodies:
  // m/s, rad/s, in each substep: velocity change by pulls and ties.
  Vec3 dv = Vec3::Zero(), dw = Vec3::Zero();
};

/// One side of a contact or tie: a point and its response to impulses.
struct Side {
  SoftMember* soft = nullptr;
  std::size_t member = 0;
  Rigid* rigid = nullptr;
  const contact::ContactSide* at = nullptr;
  Vec3 start = Vec3::Zero();     // m, soft: position of the point at the tick's start
  Mat3 mobility = Mat3::Zero();  // 1/kg: velocity of the point per impulse on it
};

bool is_thin(const Side& side) {
  return side.soft && side.soft->body->anatomy().thickness > 0;
}

struct ImpulseJoint {
  Side a, b;
  double opening_speed = 0;      // m/s, contacts
  double gap = 0;                // m, contacts: at the substep's start
  Vec3 foreseen = Vec3::Zero();  // m/s, contacts: predicted change of a − b in the substep, without impulses
  double normal = 0;             // N·s, of the substep
  Vec3 impulse = Vec3::Zero();   // N·s, of the substep; contacts: friction; ties: total
};

/// Buffers that are reused in the next tick.
struct Buffers {
  std::vector<Rigid> rigid;
  std::vector<ImpulseJoint> contacts, ties;
  TiedResponse held;
};

class Coupling {
 public:
  Coupling(Island& island, const SubstepTick& tick, std::span<SubstepWork> work, Buffers& buffers)
      : island_(island),
        tick_(tick),
        work_(work),
        rigid_(buffers.rigid),
        held_(buffers.held),
        contacts_(buffers.contacts),
        ties_(buffers.ties) {
    rigid_.clear();
    rigid_.reserve(island.rigid.size());  // sides point into this vector
    for (const RigidMember& m : island.rigid) add_rigid(m);
    held_.find(island, tick.h);
    for (std::size_t k = 0; k < held_.members().size(); ++k) {
      const RigidMember& m = island.rigid[held_.members()[k]];
      Rigid& r = rigid_[held_.members()[k]];
      r.held = k;
      r.dv = (m.twist - m.steady).head<3>() / (tick.h * tick.substeps);
      r.dw = (m.twist - m.steady).tail<3>() / (tick.h * tick.substeps);
      r.v = m.steady.head<3>() / tick.h;
      r.w = m.steady.tail<3>() / tick.h;
    }
    contacts_.clear();
    for (const std::size_t c : tick.contacts) {
      contact::Contact& contact = island.contacts[c];
      ImpulseJoint& joint = contacts_.emplace_back();
      joint = {resolve(contact.a), resolve(contact.b)};
      joint.opening_speed =
          is_thin(joint.a) && (!joint.b.soft || is_thin(joint.b)) ? thin_opening_speed : opening_speed;
      contact.force = 0;
      contact.exchanged.setZero();
    }
    ties_.clear();
    for (const std::size_t t : tick.ties)
      ties_.push_back({resolve(island.ties[t].a), resolve(island.ties[t].b)});
  }

  void run() {
    const double hs = tick_.h / tick_.substeps;
    for (std::size_t m = 0; m < island_.soft.size(); ++m)
      if (tick_.substepped[m]) island_.soft[m].body->substepper()->begin(*island_.soft[m].state);
    for (int k = 0; k < tick_.substeps; ++k) {
      passed_ = static_cast<double>(k) / tick_.substeps;
      for (Rigid& r : rigid_) {
        r.v += r.dv;
        r.w += r.dw;
      }
      if (k == 0) foresee_fall(hs);
      meet(hs);
      for (std::size_t m = 0; m < island_.soft.size(); ++m) {
        SoftMember& member = island_.soft[m];
        if (tick_.substepped[m]) member.body->substepper()->step(hs, member.weight, *member.state);
      }
      passed_ = static_cast<double>(k + 1) / tick_.substeps;
      learn();
      hold(hs);
      for (Rigid& r : rigid_) {
        r.moved += hs * r.v;
        r.turned += hs * r.w;
      }
    }
    for (std::size_t m = 0; m < rigid_.size(); ++m)
      island_.rigid[m].twist << tick_.h * rigid_[m].v, tick_.h * rigid_[m].w;
  }

 private:
  void add_rigid(const RigidMember& m) {
    Rigid& r = rigid_.emplace_back();
    r.v = m.twist.head<3>() / tick_.h;
    r.w = m.twist.tail<3>() / tick_.h;
    const double pulled = m.pull ? m.pull->stiffness * tick_.h * tick_.h : 0;
    const double turned = m.pull ? m.pull->angular_stiffness * tick_.h * tick_.h : 0;
    r.inverse_mass = 1 / (m.mass + pulled);
    r.inverse_inertia = (m.inertia + turned * Mat3::Identity()).inverse();
  }

  Side resolve(const contact::ContactSide& side) {
    Side out;
    out.at = &side;
    if (side.kind == contact::ContactSide::Kind::soft) {
      while (island_.soft[out.member].index != side.body) ++out.member;
      out.soft = &island_.soft[out.member];
      double sum = 0;
      for (std::size_t k = 0; k < side.nodes; ++k) {
        const auto node = static_cast<Eigen::Index>(side.node[k]);
        out.start += side.weight[k] * tick_.start[out.member].motion.x.segment<3>(3 * node);
        sum += side.weight[k] * side.weight[k] / out.soft->body->node_mass()[node];
      }
      out.mobility = sum * Mat3::Identity();
    } else if (side.kind == contact::ContactSide::Kind::rigid) {
      std::size_t m = 0;
      while (island_.rigid[m].slot != side.body) ++m;
      out.rigid = &rigid_[m];
      out.mobility = mobility(*out.rigid, side.arm);
    }
    return out;
  }

  Mat3 mobility(const Rigid& rigid, const Vec3& arm) const {
    if (rigid.held) return lever(arm) * held_.response(*rigid.held, *rigid.held) * lever(arm).transpose();
    const Mat3 cross = soft::cross_matrix(arm);
    return rigid.inverse_mass * Mat3::Identity() - cross * rigid.inverse_inertia * cross;
  }

  static Vec3 weighted(const Side& side, const VecX& values) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = 0; k < side.at->nodes; ++k)
      sum += side.at->weight[k] * values.segment<3>(3 * static_cast<Eigen::Index>(side.at->node[k]));
    return sum;
  }

  Vec3 velocity(const Side& side) const {
    if (side.soft) return weighted(side, side.soft->state->motion.v);
    return side.rigid ? Vec3(side.rigid->v + side.rigid->w.cross(side.at->arm))
                      : Vec3(side.at->moved / tick_.h);
  }

  /// Returns a side's displacement since the tick's start. Minimised bodies, whose tick is already done, move
  /// at constant velocity between its start and end.
  Vec3 displacement(const Side& side) const {
    if (side.soft) {
      const Vec3 u = weighted(side, side.soft->state->motion.x) - side.start;
      return tick_.substepped[side.member] ? u : Vec3(passed_ * u);
    }
    if (!side.rigid) return passed_ * side.at->moved;
    return side.rigid->moved + side.rigid->turned.cross(side.at->arm);
  }

  /// Returns the time for which a tie extrapolates a side's velocity, s. A rigid body's position at the
  /// tick's end is h times its final velocity, so ties assume constant velocity from the tick's start. With
  /// the sum of its velocities in the tick, its position would jump between ticks. A light tool, whose hand
  /// counts as inertia k·h², would then oscillate with a period of two ticks.
  double carried(const Side& side, double hs) const { return side.rigid ? passed_ * tick_.h : hs; }
  Vec3 tied_at(const Side& side, double hs) const {
    return side.rigid ? Vec3(carried(side, hs) * velocity(side)) : displacement(side);
  }

  /// Returns the gap between the surfaces. Impulses open overlaps without storing elastic energy, so no rest
  /// gap is needed.
  double gap(const ImpulseJoint& joint, const contact::Contact& contact) const {
    return contact.gap + contact.rest + contact.normal.dot(displacement(joint.a) - displacement(joint.b));
  }

  /// Applies an impulse to a side; node positions change by `ahead` s times the velocity change. Returns the
  /// gain of kinetic energy, J.
  double push(const Side& side, const Vec3& impulse, double ahead) const {
    double gained = 0;
    if (side.soft) {
      soft::Motion& motion = side.soft->state->motion;
      for (std::size_t k = 0; k < side.at->nodes; ++k) {
        const auto node = static_cast<Eigen::Index>(side.at->node[k]);
        const Vec3 change = side.at->weight[k] / side.soft->body->node_mass()[node] * impulse;
        auto v = motion.v.segment<3>(3 * node);
        gained += side.at->weight[k] * impulse.dot(v + change / 2);
        v += change;
        motion.x.segment<3>(3 * node) += ahead * change;
      }
      motion.has_history = false;
      work_[side.member].done += gained;
    } else {
      const Vec3 before = velocity(side);
      if (side.rigid) push(*side.rigid, side.at->arm, impulse);
      gained = impulse.dot(before + velocity(side)) / 2;
    }
    return gained;
  }

  void push(Rigid& rigid, const Vec3& arm, const Vec3& impulse) const {
    if (!rigid.held) {
      rigid.v += rigid.inverse_mass * impulse;
      rigid.w += rigid.inverse_inertia * arm.cross(impulse);
      return;
    }
    const Vec6 pushed = lever(arm).transpose() * impulse;
    for (std::size_t k = 0; k < held_.members().size(); ++k) {
      const Vec6 change = held_.response(k, *rigid.held) * pushed;
      rigid_[held_.members()[k]].v += change.head<3>();
      rigid_[held_.members()[k]].w += change.tail<3>();
    }
  }

  double push(const ImpulseJoint& joint, const Vec3& impulse, double ahead) const {
    return push(joint.a, impulse, ahead) + push(joint.b, -impulse, ahead);
  }

  void press_on(const ImpulseJoint& joint, const Vec3& impulse) const {
    const double made = push(joint, impulse, 0);
    if (joint.a.soft) work_[joint.a.member].made += made;
    if (joint.b.soft) work_[joint.b.member].made += made;
  }

  Vec3 relative_velocity(const ImpulseJoint& joint) const { return velocity(joint.a) - velocity(joint.b); }

  /// Returns the velocity change by gravity in a substep, m/s.
  Vec3 fall(const Side& side, double hs) const {
    if (!side.soft || !tick_.substepped[side.member]) return Vec3::Zero();
    return hs * side.soft->weight.acceleration;
  }

  void foresee_fall(double hs) {
    for (ImpulseJoint& joint : contacts_) joint.foreseen = fall(joint.a, hs) - fall(joint.b, hs);
  }

  /// Applies contact impulses before the substep. They change velocities only, so that they strain nothing.
  void meet(double hs) {
    for (std::size_t c = 0; c < contacts_.size(); ++c) {
      contacts_[c].gap = gap(contacts_[c], contact(c));
      contacts_[c].normal = 0;
      contacts_[c].impulse.setZero();
    }
    for (int sweep = 0; sweep < sweeps; ++sweep)
      for (std::size_t c = 0; c < contacts_.size(); ++c) press(contacts_[c], contact(c), hs);
    for (std::size_t c = 0; c < contacts_.size(); ++c) {
      ImpulseJoint& joint = contacts_[c];
      contact(c).force += joint.normal / tick_.h;
      contact(c).exchanged += (joint.normal * contact(c).normal + joint.impulse) / tick_.h;
      joint.foreseen = -relative_velocity(joint);
    }
  }

  /// Measures the bodies' own velocity change in the substep since meet(), as a prediction for the next one.
  void learn() {
    for (ImpulseJoint& joint : contacts_) {
      joint.foreseen += relative_velocity(joint);
      if (const double size = joint.foreseen.norm(); size > most_foreseen)
        joint.foreseen *= most_foreseen / size;
    }
  }

  /// Applies the ties' impulses after the substep.
  void hold(double hs) {
    for (ImpulseJoint& joint : ties_) joint.impulse.setZero();
    for (int sweep = 0; sweep < sweeps; ++sweep)
      for (std::size_t t = 0; t < ties_.size(); ++t) pull(ties_[t], island_.ties[tick_.ties[t]], hs);
  }

  /// Applies the tie's spring over the substep, integrated by implicit Euler and bounded.
  void pull(ImpulseJoint& joint, const contact::Tie& tie, double hs) const {
    const Vec3 stretch = tie.offset + tied_at(joint.a, hs) - tied_at(joint.b, hs);
    const Mat3 A = Mat3::Identity() +
                   hs * tie.stiffness *
                       (carried(joint.a, hs) * joint.a.mobility + carried(joint.b, hs) * joint.b.mobility);
    Vec3 total = joint.impulse - A.inverse() * (hs * tie.stiffness * stretch + joint.impulse);
    const double most = tie.max_force * hs;
    if (total.norm() > most) total *= most / total.norm();
    push(joint, total - joint.impulse, hs);
    joint.impulse = total;
  }

  void press(ImpulseJoint& joint, const contact::Contact& contact, double hs) const {
    const Mat3 mobility = joint.a.mobility + joint.b.mobility;
    const double along = contact.normal.dot(mobility * contact.normal);
    if (!(along > 0)) return;
    const double ahead = joint.gap + hs * contact.normal.dot(relative_velocity(joint) + joint.foreseen);
    const double goal = std::min(0.0, joint.gap + joint.opening_speed * hs);
    const double normal = std::max(0.0, joint.normal + (goal - ahead) / (hs * along));
    press_on(joint, (normal - joint.normal) * contact.normal);
    joint.normal = normal;
    rub(joint, contact, mobility);
  }

  /// Removes tangential velocity by friction, within Coulomb's cone.
  void rub(ImpulseJoint& joint, const contact::Contact& contact, const Mat3& mobility) const {
    const double most = contact.friction * joint.normal;
    if (!(most > 0) && joint.impulse.isZero()) return;
    const Vec3& n = contact.normal;
    Vec3 slip = relative_velocity(joint) + joint.foreseen;
    slip -= n.dot(slip) * n;
    const double across = (mobility.trace() - n.dot(mobility * n)) / 2;
    Vec3 total = joint.impulse - slip / across;
    if (total.norm() > most) total *= most / total.norm();
    press_on(joint, total - joint.impulse);
    joint.impulse = total;
  }

  contact::Contact& contact(std::size_t c) const { return island_.contacts[tick_.contacts[c]]; }

  Island& island_;
  const SubstepTick& tick_;
  std::span<SubstepWork> work_;
  double passed_ = 0;  // fraction of the tick at the substep's end
  std::vector<Rigid>& rigid_;
  TiedResponse& held_;
  std::vector<ImpulseJoint>&contacts_, &ties_;
};

}  // namespace

struct ImpulseCoupling::Impl {
  Buffers buffers;
};

ImpulseCoupling::ImpulseCoupling() : impl_(std::make_unique<Impl>()) {}
ImpulseCoupling::~ImpulseCoupling() = default;
ImpulseCoupling::ImpulseCoupling(ImpulseCoupling&&) noexcept = default;

void ImpulseCoupling::run(Island& island, const SubstepTick& tick, std::span<SubstepWork> work) {
  PROSECTOR_ASSERT(tick.substeps > 0 && tick.h > 0);
  PROSECTOR_ASSERT(tick.start.size() == island.soft.size() && tick.substepped.size() == island.soft.size() &&
                   work.size() == island.soft.size());
  std::fill(work.begin(), work.end(), SubstepWork{});
  Coupling(island, tick, work, impl_->buffers).run();
}

}  // namespace prosector::coupled
