#include "server/physics/coupled/impulse_coupling.h"

#include <Eigen/LU>
#include <algorithm>

#include "server/physics/soft/substepper.h"

namespace prosector {
namespace {

constexpr int sweeps = 4;               // over all contacts and ties, per substep
constexpr double opening_speed = 0.25;  // m/s, at most, of what overlaps when the tick starts

struct Rigid {
  Vec3 v, w;                                         // m/s, rad/s
  Vec3 moved = Vec3::Zero(), turned = Vec3::Zero();  // since the tick's start: m, rad
  double inverse_mass;
  Mat3 inverse_inertia;
};

/// One side of a contact or tie: a point and what an impulse on it does.
struct Side {
  SoftMember* soft = nullptr;
  std::size_t member = 0;
  Rigid* rigid = nullptr;
  const ContactSide* at = nullptr;
  Vec3 start = Vec3::Zero();     // m, soft: the point at the tick's start
  Mat3 mobility = Mat3::Zero();  // 1/kg: velocity of the point per impulse on it
};

Mat3 cross_matrix(const Vec3& v) {
  Mat3 m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

class Coupling {
 public:
  /// `before`: node positions of each soft member at the tick's start.
  Coupling(Island& island, std::span<const VecX> before, std::span<const char> substepped,
           std::span<const std::size_t> contacts, std::span<const std::size_t> ties, double h,
           std::span<double> work)
      : island_(island),
        work_(work),
        before_(before),
        substepped_(substepped),
        contact_index_(contacts),
        tie_index_(ties),
        h_(h) {
    rigid_.reserve(island.rigid.size());  // sides point into it
    for (const RigidMember& m : island.rigid) add_rigid(m);
    for (const std::size_t c : contacts)
      contacts_.push_back({resolve(island.contacts[c].a), resolve(island.contacts[c].b)});
    for (const std::size_t t : ties) ties_.push_back({resolve(island.ties[t].a), resolve(island.ties[t].b)});
    for (const std::size_t c : contacts) island.contacts[c].force = 0;
  }

  void run(int substeps, const Vec3& gravity) {
    const double hs = h_ / substeps;
    for (std::size_t m = 0; m < island_.soft.size(); ++m)
      if (substepped_[m]) island_.soft[m].body->substepper()->begin(*island_.soft[m].state);
    for (int k = 0; k < substeps; ++k) {
      passed_ = static_cast<double>(k + 1) / substeps;
      for (std::size_t c = 0; c < contacts_.size(); ++c) contacts_[c].gap = gap(c, 0);
      for (std::size_t m = 0; m < island_.soft.size(); ++m) {
        SoftMember& member = island_.soft[m];
        const bool falls = member.body->desc().gravity;
        if (substepped_[m])
          member.body->substepper()->step(hs, falls ? gravity : Vec3::Zero(), *member.state);
      }
      exchange(hs);
      for (Rigid& r : rigid_) {
        r.moved += hs * r.v;
        r.turned += hs * r.w;
      }
    }
    for (std::size_t m = 0; m < rigid_.size(); ++m)
      island_.rigid[m].twist << h_ * rigid_[m].v, h_ * rigid_[m].w;
  }

 private:
  struct Joint {
    Side a, b;
    double gap = 0;               // m, contacts: when the substep starts
    double normal = 0;            // N·s, of the substep
    Vec3 impulse = Vec3::Zero();  // N·s, of the substep: contacts: friction; ties: all
  };

  void add_rigid(const RigidMember& m) {
    Rigid& r = rigid_.emplace_back();
    r.v = m.twist.head<3>() / h_;
    r.w = m.twist.tail<3>() / h_;
    const double pulled = m.pull ? m.pull->stiffness * h_ * h_ : 0;
    const double turned = m.pull ? m.pull->angular_stiffness * h_ * h_ : 0;
    r.inverse_mass = 1 / (m.mass + pulled);
    r.inverse_inertia = (m.inertia + turned * Mat3::Identity()).inverse();
  }

  Side resolve(const ContactSide& side) {
    Side out;
    out.at = &side;
    if (side.kind == ContactSide::Kind::soft) {
      while (island_.soft[out.member].index != side.body) ++out.member;
      out.soft = &island_.soft[out.member];
      double sum = 0;
      for (std::size_t k = 0; k < side.nodes; ++k) {
        const auto node = static_cast<Eigen::Index>(side.node[k]);
        out.start += side.weight[k] * before_[out.member].segment<3>(3 * node);
        sum += side.weight[k] * side.weight[k] / out.soft->body->node_mass()[node];
      }
      out.mobility = sum * Mat3::Identity();
    } else if (side.kind == ContactSide::Kind::rigid) {
      std::size_t m = 0;
      while (island_.rigid[m].slot != side.body) ++m;
      out.rigid = &rigid_[m];
      const Mat3 arm = cross_matrix(side.arm);
      out.mobility = out.rigid->inverse_mass * Mat3::Identity() - arm * out.rigid->inverse_inertia * arm;
    }
    return out;
  }

  static Vec3 weighted(const Side& side, const VecX& values) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = 0; k < side.at->nodes; ++k)
      sum += side.at->weight[k] * values.segment<3>(3 * static_cast<Eigen::Index>(side.at->node[k]));
    return sum;
  }

  static Vec3 velocity(const Side& side) {
    if (side.soft) return weighted(side, side.soft->state->motion.v);
    return side.rigid ? Vec3(side.rigid->v + side.rigid->w.cross(side.at->arm)) : Vec3(Vec3::Zero());
  }

  /// Displacement since the tick's start, `ahead` s from now for rigid bodies; minimised bodies, whose tick
  /// is done already, are passed through evenly.
  Vec3 displacement(const Side& side, double ahead) const {
    if (side.soft) {
      const Vec3 u = weighted(side, side.soft->state->motion.x) - side.start;
      return substepped_[side.member] ? u : Vec3(passed_ * u);
    }
    if (!side.rigid) return Vec3::Zero();
    const Rigid& r = *side.rigid;
    return r.moved + ahead * r.v + (r.turned + ahead * r.w).cross(side.at->arm);
  }

  double gap(std::size_t c, double ahead) const {
    const Contact& contact = island_.contacts[contact_index_[c]];
    return contact.gap +
           contact.normal.dot(displacement(contacts_[c].a, ahead) - displacement(contacts_[c].b, ahead));
  }

  void push(const Side& side, const Vec3& impulse, double hs) const {
    if (side.soft) {
      Motion& motion = side.soft->state->motion;
      for (std::size_t k = 0; k < side.at->nodes; ++k) {
        const auto node = static_cast<Eigen::Index>(side.at->node[k]);
        const Vec3 change = side.at->weight[k] / side.soft->body->node_mass()[node] * impulse;
        auto v = motion.v.segment<3>(3 * node);
        work_[side.member] += side.at->weight[k] * impulse.dot(v + change / 2);
        v += change;
        motion.x.segment<3>(3 * node) += hs * change;
      }
      motion.has_history = false;
    } else if (side.rigid) {
      side.rigid->v += side.rigid->inverse_mass * impulse;
      side.rigid->w += side.rigid->inverse_inertia * side.at->arm.cross(impulse);
    }
  }

  void push(const Joint& joint, const Vec3& impulse, double hs) const {
    push(joint.a, impulse, hs);
    push(joint.b, -impulse, hs);
  }

  void exchange(double hs) {
    for (auto* joints : {&contacts_, &ties_})
      for (Joint& joint : *joints) {
        joint.normal = 0;
        joint.impulse.setZero();
      }
    for (int sweep = 0; sweep < sweeps; ++sweep) {
      for (std::size_t t = 0; t < ties_.size(); ++t) pull(ties_[t], island_.ties[tie_index_[t]], hs);
      for (std::size_t c = 0; c < contacts_.size(); ++c) press(c, hs);
    }
    for (std::size_t c = 0; c < contacts_.size(); ++c)
      island_.contacts[contact_index_[c]].force += contacts_[c].normal / h_;
  }

  /// The tie's spring over the substep, as implicit Euler would have it, bounded.
  void pull(Joint& joint, const Tie& tie, double hs) const {
    const Vec3 stretch = tie.offset + displacement(joint.a, hs) - displacement(joint.b, hs);
    const Mat3 A = Mat3::Identity() + hs * hs * tie.stiffness * (joint.a.mobility + joint.b.mobility);
    Vec3 total = joint.impulse - A.inverse() * (hs * tie.stiffness * stretch + joint.impulse);
    const double most = tie.max_force * hs;
    if (total.norm() > most) total *= most / total.norm();
    push(joint, total - joint.impulse, hs);
    joint.impulse = total;
  }

  void press(std::size_t c, double hs) {
    Joint& joint = contacts_[c];
    const Contact& contact = island_.contacts[contact_index_[c]];
    const Mat3 mobility = joint.a.mobility + joint.b.mobility;
    const double along = contact.normal.dot(mobility * contact.normal);
    if (!(along > 0)) return;
    const double goal = std::min(0.0, joint.gap + opening_speed * hs);
    const double normal = std::max(0.0, joint.normal + (goal - gap(c, hs)) / (hs * along));
    push(joint, (normal - joint.normal) * contact.normal, hs);
    joint.normal = normal;
    rub(joint, contact, mobility, hs);
  }

  /// Friction takes the tangential velocity away as far as Coulomb's cone allows.
  void rub(Joint& joint, const Contact& contact, const Mat3& mobility, double hs) const {
    const double most = contact.friction * joint.normal;
    if (!(most > 0) && joint.impulse.isZero()) return;
    const Vec3& n = contact.normal;
    Vec3 slip = velocity(joint.a) - velocity(joint.b);
    slip -= n.dot(slip) * n;
    const double across = (mobility.trace() - n.dot(mobility * n)) / 2;
    Vec3 total = joint.impulse - slip / across;
    if (total.norm() > most) total *= most / total.norm();
    push(joint, total - joint.impulse, hs);
    joint.impulse = total;
  }

  Island& island_;
  std::span<double> work_;
  std::span<const VecX> before_;
  std::span<const char> substepped_;
  std::span<const std::size_t> contact_index_, tie_index_;
  double h_, passed_ = 0;  // s; share of the tick when the substep ends
  std::vector<Rigid> rigid_;
  std::vector<Joint> contacts_, ties_;
};

}  // namespace

void couple_by_impulses(Island& island, std::span<const VecX> before, std::span<const char> substepped,
                        std::span<const std::size_t> contacts, std::span<const std::size_t> ties,
                        int substeps, double h, const Vec3& gravity, std::span<double> work) {
  std::fill(work.begin(), work.end(), 0.0);
  Coupling(island, before, substepped, contacts, ties, h, work).run(substeps, gravity);
}

}  // namespace prosector
