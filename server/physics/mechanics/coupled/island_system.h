#pragma once
// An island's energy, gradient and Hessian, the latter matrix-free. Sums the parts of soft bodies, rigid
// bodies (rigid_elimination.h) and joints (island_joints.h).

#include <Eigen/Cholesky>
#include <optional>
#include "server/physics/mechanics/coupled/island_joints.h"
#include "server/physics/mechanics/coupled/rigid_block.h"
#include "server/physics/mechanics/coupled/rigid_elimination.h"
#include "server/physics/mechanics/soft/solvers/linear_solver.h"

namespace prosector::coupled {

/// Newton system of an island: the energy, gradient and matrix-free Hessian of its soft bodies, rigid bodies,
/// contacts and ties. Also the operator and the preconditioners for the linear solver.
class IslandSystem final : public soft::LinearOperator {
 public:
  /// Sets up the system for a tick of h s. Displacements of soft nodes are measured from their current
  /// positions. Stores a pointer to `island`, which must outlive its use here. Allocates memory only for an
  /// island that is larger than those before.
  void begin(Island& island, double h);

  const IslandLayout& layout() const { return layout_; }
  IslandJoints& joints() { return joints_; }

  /// Sets the unknowns q to the starting point of the Newton iteration: the soft bodies' own prediction, and
  /// motion at constant velocity for rigid bodies. With free fall instead, contacts would start deep, and
  /// friction under such forces would stop sliding bodies.
  void initial_guess(VecX& q) const;
  /// Sets the unknowns q to the positions at the tick's start for soft nodes. For rigid bodies, sets them to
  /// the displacement that they would have without contacts.
  void start(VecX& q) const;

  /// Returns the island's incremental energy (J) at the unknowns q: soft bodies, rigid bodies, contacts and
  /// ties, with the friction limits last set.
  double energy(const VecX& q);
  /// Returns the island's energy (J) after joints().lag_friction() changed the friction limits. `q` must be
  /// the same unknowns as in the last call of energy(), whose soft-body energy is reused instead of visiting
  /// the elements.
  double energy_with_new_friction(const VecX& q) { return soft_energy_ + energy_but_soft(q); }
  /// Returns the energy (J) stored in tissue and its attachments, including the tick's dissipation by
  /// stiffness-proportional damping, without inertia. `q` must be the same unknowns as in the last call of
  /// energy().
  double stored_in_tissue(const VecX& q) const;
  /// Returns the energy (J) stored in contacts, ties and hands' pulls on rigid bodies at the unknowns q, with
  /// the friction limits last set by joints().lag_friction().
  double stored_in_joints(const VecX& q);

  /// Computes the deformation data of the soft bodies' elements at the unknowns q, which the evaluation of
  /// energy, gradient and Hessian at q uses.
  void linearise(const VecX& q);
  void gradient(const VecX& q, VecX& g);
  /// Computes the island's Hessian at the unknowns q, projected to be positive definite. If not `exact`, a
  /// soft body that moved little since its last matrix or since the tick's start uses an approximation from
  /// there. Returns whether at least one did.
  bool assemble(const VecX& q, bool exact);

  /// Converts g, the right side of the full Newton system, into that of the linear solver, from which the
  /// rigid bodies are eliminated (Schur complement). Does nothing if they are not eliminated.
  void condense(VecX& g) const { rigid_.condense(g); }
  /// Computes the full Newton step, including the eliminated rigid bodies. `g`: the full right side;
  /// `solved`: the linear solver's solution for the right side from condense().
  void expand(const VecX& g, const VecX& solved, VecX& step) const { rigid_.expand(g, solved, step); }

  Eigen::Index size() const override { return layout_.size; }
  void multiply(const VecX& p, VecX& Hp) const override;
  void block_jacobi(const VecX& r, VecX& z) const override;
  void elastic_factor(const VecX& r, VecX& z) const override;
  void multigrid(const VecX& r, VecX& z) const override;

 private:
  double energy_but_soft(const VecX& q);
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

}  // namespace prosector::coupled
