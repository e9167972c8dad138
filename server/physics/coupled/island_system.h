#pragma once
// An island's energy, gradient and Hessian, the last matrix-free. It puts together its soft bodies', its
// rigid bodies' (rigid_elimination.h) and what joins them (island_joints.h).

#include <Eigen/Cholesky>
#include <optional>
#include "server/physics/coupled/island_joints.h"
#include "server/physics/coupled/rigid_block.h"
#include "server/physics/coupled/rigid_elimination.h"
#include "server/physics/soft/solvers/linear_solver.h"

namespace prosector {

class IslandSystem final : public LinearOperator {
 public:
  /// Takes the island, which must outlive what is asked of it, over a tick of h s. Displacements count from
  /// where it is now. Allocates only for an island that is larger than those before.
  void begin(Island& island, double h);

  const IslandLayout& layout() const { return layout_; }
  IslandJoints& joints() { return joints_; }
  const IslandJoints& joints() const { return joints_; }

  /// Fills in a warm start: the soft bodies' own guess; rigid bodies go on as they did. Were they to fall
  /// freely, contacts would be deep, and friction under such forces would stop what slides.
  void initial_guess(VecX& q) const;
  /// Fills in where the tick began, and the rigid bodies' prediction.
  void start(VecX& q) const;

  /// Returns the energy at q, J.
  double energy(const VecX& q);
  /// Returns the same at the q of the last energy(), after joints().lag_friction() changed the friction: no
  /// elements are visited.
  double energy_with_new_friction(const VecX& q) const { return soft_energy_ + energy_but_soft(q); }
  /// Returns the energy in tissue and its attachments at the q of the last energy(), J, with what stiffness
  /// damping takes in the tick.
  double stored_in_tissue(const VecX& q) const;
  /// Returns the energy at q in contacts with the friction as lagged, in ties and pulls, J.
  double stored_in_joints(const VecX& q) const;

  /// Tells soft bodies that energy, gradient and Hessian will be asked for at q.
  void linearise(const VecX& q);
  void gradient(const VecX& q, VecX& g);
  /// Fixes the Hessian at q. Unless it is to be `exact`, soft bodies that moved little since the tick's start
  /// keep the matrix that they have from there. Returns true when some did.
  bool assemble(const VecX& q, bool exact);

  /// Makes a right side of the whole one of the linear solver's, see RigidElimination.
  void condense(VecX& g) const { rigid_.condense(g); }
  /// Returns the whole step for the right side g. `solved`: the solution for what condense() made of g.
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
  std::vector<const Joint*> stiff_;  // those with a stiffness since the last assemble() …
  JointProduct product_;             // … and they as the linear solver has them
  std::vector<Mat3> node_blocks_, node_inverse_;
  std::vector<double> energies_;  // J, by soft member, of the last energy()
  std::vector<char> kept_;        // by soft member, whether its matrix was kept in the last assemble()
};

}  // namespace prosector
