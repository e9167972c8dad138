#pragma once
// Hessian of a single soft body plus springs on its nodes, as an operator for linear solvers.

#include <vector>

#include "server/physics/mechanics/soft/incremental_potential.h"
#include "server/physics/mechanics/soft/solvers/linear_solver.h"

namespace prosector::soft {

class BodyOnSprings final : public LinearOperator {
 public:
  /// Initialises the Hessian of a soft body with this number of nodes plus springs at its nodes, as an
  /// operator for the linear solver. Stores a reference to the body's `potential`, which must outlive this
  /// object.
  BodyOnSprings(IncrementalPotential& potential, Eigen::Index nodes);
  /// Spring on a material point of the body: a 3×3 stiffness (N/m), and the nodes with weights whose weighted
  /// sum is the point's position.
  struct Spring {
    std::vector<std::pair<Eigen::Index, double>> nodes;
    Mat3 stiffness;
  };
  /// Updates the operator: takes the Hessian that the body's potential assembled last, and replaces the
  /// springs by `springs`.
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

}  // namespace prosector::soft
