#pragma once
// Hessian of a single soft body plus springs on its nodes, as an operator for linear solvers.

#include <vector>

#include "server/physics/mechanics/soft/incremental_potential.h"
#include "server/physics/mechanics/soft/solvers/linear_solver.h"

namespace prosector {

class BodyOnSprings final : public LinearOperator {
 public:
  /// Takes the potential, which must outlive this object.
  BodyOnSprings(IncrementalPotential& potential, Eigen::Index nodes);
  /// A 3×3 stiffness (N/m) on a point that is a weighted sum of nodes.
  struct Spring {
    std::vector<std::pair<Eigen::Index, double>> nodes;
    Mat3 stiffness;
  };
  /// Updates the operator from the potential's last assembly and sets the springs.
  void refresh(std::vector<Spring> springs = {});

  Eigen::Index size() const override { return 3 * static_cast<Eigen::Index>(diagonal_.size()); }
  void multiply(const VecX& p, VecX& Hp) const override;
  void block_jacobi(const VecX& r, VecX& z) const override;
  void elastic_factor(const VecX& r, VecX& z) const override;
  void multigrid(const VecX& r, VecX& z) const override;

 private:
  IncrementalPotential& potential_;
  std::vector<Spring> springs_;
  std::vector<Mat3> diagonal_, inverse_;
};

}  // namespace prosector
