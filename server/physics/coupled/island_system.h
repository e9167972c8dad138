#pragma once
// An island's energy, gradient and Hessian, the last matrix-free.

#include <Eigen/Cholesky>

#include "server/physics/coupled/island.h"

namespace prosector {

class IslandSystem final : public LinearOperator {
 public:
  /// Takes the island, which must outlive what is asked of it, over a tick of h s. Displacements count from
  /// where it is now. Allocates only for an island that is larger than those before.
  void begin(Island& island, double h);

  /// Warm start: the soft bodies' own guess, the rigid bodies' prediction.
  void initial_guess(VecX& q) const;
  /// Where the tick began, rigid bodies' prediction.
  void start(VecX& q) const;
  /// Normal forces that friction uses until the next call: those at q.
  void lag_friction(const VecX& q);
  double energy(const VecX& q);
  /// The same at the q of the last energy(), after lag_friction() changed the friction: no elements visited.
  double energy_with_new_friction(const VecX& q) const { return soft_energy_ + joint_energy(q); }
  /// Tells soft bodies that energy, gradient and Hessian will be asked for at q.
  void linearise(const VecX& q);
  void gradient(const VecX& q, VecX& g);
  /// Fixes the Hessian at q. Unless it is to be `exact`, soft bodies that moved little since the tick's start
  /// keep the matrix that they have from there. True when some did.
  bool assemble(const VecX& q, bool exact);

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
  /// Normal force of a contact at q, N.
  double normal_force(const Contact& contact, const VecX& q) const;

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
    Vec3 at_start;  // the linear map of the positions at the tick's start
    Mat3 D = Mat3::Zero();
  };

  Side resolve(const ContactSide& side) const;
  Joint join(const ContactSide& a, const ContactSide& b) const;
  static Vec3 read(const Side& side, const VecX& q);
  static void add(const Side& side, const Vec3& f, VecX& out);
  Vec3 displacement(const Joint& joint, const VecX& q) const {
    return read(joint.a, q) - read(joint.b, q) - joint.at_start;
  }
  void add_block(const Side& side, const Mat3& D);
  double joint_energy(const VecX& q) const;  // all but the soft bodies' own
  double contact_energy(std::size_t c, const Vec3& u) const;
  Vec3 contact_force(std::size_t c, const Vec3& u, Mat3* D) const;

  Island* island_ = nullptr;
  double h_ = 0, slip_threshold_ = 0;
  double soft_energy_ = 0;  // J, of the last energy()
  Eigen::Index size_ = 0, rigid_begin_ = 0;
  std::vector<Eigen::Index> soft_offset_;
  std::vector<Joint> contacts_, ties_;
  std::vector<const Joint*> stiff_;  // those with a stiffness since the last assemble()
  std::vector<double> lagged_;       // N, normal force per contact
  std::vector<Mat3> node_blocks_, node_inverse_;
  std::vector<Mat6> rigid_blocks_;  // own: inertia and pull
  std::vector<Mat6> rigid_sums_;    // with contacts
  std::vector<Eigen::LLT<Mat6>> rigid_factors_;
};

}  // namespace prosector
