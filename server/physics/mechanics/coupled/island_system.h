#pragma once
// An island's energy, gradient and Hessian, the latter matrix-free. Sums the parts of soft bodies, rigid
// bodies (rigid_elimination.h) and joints (island_joints.h).

#include <Eigen/Cholesky>
#include <optional>
#include "server/physics/mechanics/coupled/island_joints.h"
#include "server/physics/mechanics/coupled/rigid_block.h"
#include "server/physics/mechanics/coupled/rigid_elimination.h"
#include "server/physics/mechanics/soft/solvers/linear_solver.h"

namespace prosector {

/// The Newton system of an island.
class IslandSystem final : public LinearOperator {
 public:
  /// Sets the island, which must outlive its use here, for a tick of h s. Displacements are measured from its
  /// current positions. Allocates only for an island that is larger than those before.
  void begin(Island& island, double h);

  const IslandLayout& layout() const { return layout_; }
  IslandJoints& joints() { return joints_; }
  const IslandJoints& joints() const { return joints_; }

  /// Sets q to a warm start: the soft bodies' own guess, and constant velocity for rigid bodies. With free
  /// fall instead, contacts would be deep, and friction under such forces would stop sliding bodies.
  void initial_guess(VecX& q) const;
  /// Sets q to the tick's start for soft bodies, and to the prediction for rigid bodies.
  void start(VecX& q) const;

  /// Returns the energy at q, J.
  double energy(const VecX& q);
  /// Returns the energy at the q of the last energy() after joints().lag_friction() changed the friction.
  /// Does not visit elements.
  double energy_with_new_friction(const VecX& q) const { return soft_energy_ + energy_but_soft(q); }
  /// Returns the energy (J) in tissue and its attachments at the q of the last energy(), including
  /// stiffness-proportional damping of the tick.
  double stored_in_tissue(const VecX& q) const;
  /// Returns the energy (J) in contacts, ties and pulls at q, with friction as lagged.
  double stored_in_joints(const VecX& q) const;

  /// Prepares the soft bodies for the evaluation of energy, gradient and Hessian at q.
  void linearise(const VecX& q);
  void gradient(const VecX& q, VecX& g);
  /// Computes the Hessian at q. If not `exact`, soft bodies that moved little since the tick's start keep
  /// their matrix from there. Returns whether some did.
  bool assemble(const VecX& q, bool exact);

  /// Converts the full right side into that of the linear solver, see RigidElimination.
  void condense(VecX& g) const { rigid_.condense(g); }
  /// Computes the full step for the right side g. `solved`: solution for the right side from condense().
  void expand(const VecX& g, const VecX& solved, VecX& step) const { rigid_.expand(g, solved, step); }

  Eigen::Index size() const override { return layout_.size; }
  void multiply(const VecX& p, VecX& Hp) const override;
  void block_jacobi(const VecX& r, VecX& z) const override;
  void elastic_factor(const VecX& r, VecX& z) const override;
  void multigrid(const VecX& r, VecX& z) const override;

 private:
  double energy_but_soft(const VecX& q) const;
  bool assemble_soft(const VecX& q, bool exact);
  void assemble_joints(const VecX& q);
  void add_block(const JointSide& side, const Mat3& D);

  Island* island_ = nullptr;
  double h_ = 0;
  double soft_energy_ = 0;  // J, of the last energy()
  IslandLayout layout_;
  IslandJoints joints_;
  RigidElimination rigid_;
  std::vector<const Joint*> stiff_;  // joints with a stiffness, of the last assemble()
  JointProduct product_;             // the same joints, packed for the linear solver
  std::vector<Mat3> node_blocks_, node_inverse_;
  std::vector<double> energies_;  // J, by soft member, of the last energy()
  std::vector<char> kept_;        // by soft member: whether its matrix was kept in the last assemble()
};

}  // namespace prosector
