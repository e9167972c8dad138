#pragma once
// The Hessian of a soft body by itself, with what presses on its nodes, as linear solvers see it.

#include <vector>

#include "server/physics/soft/incremental_potential.h"
#include "server/physics/soft/solvers/linear_solver.h"

namespace prosector {

class BodyOnSprings final : public LinearOperator {
 public:
  /// Takes the potential, which must outlive this.
  BodyOnSprings(IncrementalPotential& potential, Eigen::Index nodes);
  /// A 3×3 stiffness (N/m) on a point that hangs on nodes by weights.
  struct Spring {
    std::vector<std::pair<Eigen::Index, double>> nodes;
    Mat3 stiffness;
  };
  /// Takes in the potential's last assembly, and springs besides.
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
