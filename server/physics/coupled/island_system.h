#pragma once
// An island's energy, gradient and Hessian, the last matrix-free.

#include <Eigen/Cholesky>

#include <optional>

#include "server/physics/coupled/rigid_block.h"
#include "server/physics/soft/solvers/linear_solver.h"

namespace prosector {

inline constexpr double slip_threshold = 2e-5;  // m: over it friction builds up; what holds gives way by less

class IslandSystem final : public LinearOperator {
 public:
  /// Takes the island, which must outlive what is asked of it, over a tick of h s. Displacements count from
  /// where it is now. Allocates only for an island that is larger than those before.
  void begin(Island& island, double h);

  /// Warm start: the soft bodies' own guess; rigid bodies go on as they did. Were they to fall freely,
  /// contacts would be deep, and friction under such forces would stop what slides.
  void initial_guess(VecX& q) const;
  /// Where the tick began, rigid bodies' prediction.
  void start(VecX& q) const;
  /// Normal forces that friction uses until the next call: those at q.
  void lag_friction(const VecX& q);
  double energy(const VecX& q);
  /// The same at the q of the last energy(), after lag_friction() changed the friction: no elements visited.
  double energy_with_new_friction(const VecX& q) const { return soft_energy_ + joint_energy(q); }
  /// J, at the q of the last energy(): in tissue and its attachments, with what stiffness damping takes in
  /// the tick.
  double stored_in_tissue(const VecX& q) const;
  /// J, at q: in contacts with the friction as lagged, in ties and pulls.
  double stored_in_joints(const VecX& q) const;
  /// Tells soft bodies that energy, gradient and Hessian will be asked for at q.
  void linearise(const VecX& q);
  void gradient(const VecX& q, VecX& g);
  /// Fixes the Hessian at q. Unless it is to be `exact`, soft bodies that moved little since the tick's start
  /// keep the matrix that they have from there. True when some did.
  bool assemble(const VecX& q, bool exact);

  /// Where soft and rigid bodies meet, the linear solver sees the soft nodes' equations with the rigid
  /// bodies' eliminated (Schur's complement), so that a light body's balance is met however loosely the
  /// tissue's is: its rigid unknowns stay 0. This makes a right side of that kind of one of the whole.
  void condense(VecX& g) const;
  /// The whole step for the right side g, of the solution for what condense() made of g.
  void expand(const VecX& g, const VecX& solved, VecX& step) const;

  Eigen::Index size() const override { return size_; }
  void multiply(const VecX& p, VecX& Hp) const override;
  void block_jacobi(const VecX& r, VecX& z) const override;
  void elastic_factor(const VecX& r, VecX& z) const override;
  void multigrid(const VecX& r, VecX& z) const override;

  Eigen::Index soft_offset(std::size_t member) const { return soft_offset_[member]; }
  Eigen::Index rigid_offset(std::size_t member) const {
    return rigid_begin_ + 6 * static_cast<Eigen::Index>(member);
  }
  /// J that contacts and ties did to each soft member between `start` and q with the forces that they have at
  /// q.
  void joint_work(const VecX& start, const VecX& q, std::vector<double>& work) const;
  /// Tells that `length` of a Newton step was taken from where the Hessian was fixed: the bodies' momenta are
  /// then those that the linearised forces gave them, not those that the contacts would have at its end.
  void take(double length, const VecX& step);
  /// Tells that where the Hessian was fixed forces balance already: what is exchanged there are the contacts'
  /// forces, also when little or nothing of the next step is taken.
  void take_balanced();
  /// Whether contacts have yet to follow: at q, where the last step led, their forces (friction as lagged)
  /// are others than the step took them for, by more than a share of those on some body.
  bool unsettled(const VecX& q);
  /// Fills the contacts' results: forces at q, and what was exchanged. `all_held`: every body of the island
  /// is held or pulled, so no momentum has to add up, and what the steps left untaken counts like the rest.
  void tell_contacts(const VecX& q, bool all_held);

 private:
  /// A contact's or tie's side resolved to unknowns.
  struct Side {
    std::size_t nodes = 0;
    std::array<Eigen::Index, ContactSide::most_nodes> offset{};
    std::array<double, ContactSide::most_nodes> weight{};
    Eigen::Index rigid = -1;
    std::size_t member = 0;  // soft
    Vec3 arm = Vec3::Zero();
  };
  /// The displacement of side a relative to side b, as a linear map of the unknowns, and its 3×3 stiffness.
  struct Joint {
    Side a, b;
    Vec3 at_start;  // the linear map of the positions at the tick's start, and what is driven meanwhile
    Vec3 force = Vec3::Zero();      // N, contacts: where it was linearised, on b …
    Vec3 foreseen = Vec3::Zero();   // … what the last step took it for …
    Vec3 exchanged = Vec3::Zero();  // … and what the steps taken made of it
    double threshold = 0;           // m, contacts: slip over which friction builds up
    Vec3 held = Vec3::Zero();       // m, contacts: slip at the tick's start
    Mat3 D = Mat3::Zero();
  };

  Side resolve(const ContactSide& side) const;
  Joint join(const ContactSide& a, const ContactSide& b) const;
  Vec3 held_slip(std::size_t c) const;
  double normal_force(std::size_t c, const VecX& q) const;      // N
  double load_of_friction(std::size_t c, const VecX& q) const;  // N: what it is under
  static Vec3 read(const Side& side, const VecX& q);
  static void add(const Side& side, const Vec3& f, VecX& out);
  Vec3 displacement(const Joint& joint, const VecX& q) const {
    return read(joint.a, q) - read(joint.b, q) - joint.at_start;
  }
  void add_block(const Side& side, const Mat3& D);
  std::size_t rigid_member(const Side& side) const {
    return static_cast<std::size_t>((side.rigid - rigid_begin_) / 6);
  }
  void join_rigid();
  void factor_rigid();
  void solve_rigid(const VecX& r, VecX& z) const;
  void precondition_rigid(const VecX& r, VecX& z) const;
  void add_soft(const Side& side, const Vec3& f, VecX& out) const;
  void pass_through_rigid(VecX& Hp) const;
  double joint_energy(const VecX& q) const;  // all but the soft bodies' own
  double rigid_inertia(const RigidMember& body, const Vec6& twist) const;
  double contact_energy(std::size_t c, const Vec3& u) const;
  Vec3 contact_force(std::size_t c, const Vec3& u, Mat3* D) const;

  Island* island_ = nullptr;
  double h_ = 0;
  double soft_energy_ = 0;  // J, of the last energy()
  Eigen::Index size_ = 0, rigid_begin_ = 0;
  std::vector<Eigen::Index> soft_offset_;
  double untaken_ = 1;  // share of what balances the forces that no Newton step has brought yet
  std::vector<Joint> contacts_, ties_;
  std::vector<const Joint*> stiff_;  // those with a stiffness since the last assemble()
  std::vector<double> lagged_;       // N, normal force per contact
  std::vector<Mat3> node_blocks_, node_inverse_;
  std::vector<Mat6> rigid_blocks_;  // own: inertia and pull
  std::vector<Mat6> rigid_sums_;    // with contacts
  std::vector<Eigen::LLT<Mat6>> rigid_factors_;
  RigidBlock rigid_joined_;                    // where rigid bodies touch or hold each other …
  std::vector<RigidBlock::Pair> rigid_pairs_;  // … which
  bool joined_ = false;                        // it is factored
  bool condensed_ = false;
  /// Contact forces on a body: how large, and how far off, N.
  struct Load {
    double normal = 0, normal_off = 0, friction = 0, friction_off = 0;
  };
  std::vector<Load> soft_loads_, rigid_loads_;
  mutable VecX rigid_work_, rest_;
};

}  // namespace prosector
