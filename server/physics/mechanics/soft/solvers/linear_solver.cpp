#include "server/physics/mechanics/soft/solvers/linear_solver.h"

#include "server/physics/mechanics/soft/base/find_row.h"
#include "server/physics/mechanics/soft/solvers/conjugate_gradient.h"

namespace prosector::soft {

const std::vector<SolverRow>& solvers() {
  static const std::vector<SolverRow> rows = {
      {"cg", "conjugate gradients with block Jacobi preconditioner: cheap if low accuracy suffices", make_cg},
      {"multigrid",
       "conjugate gradients with multigrid preconditioner: few iterations at any mesh resolution",
       make_multigrid},
      {"direct",
       "sparse Cholesky factorisation, with iterative refinement for contacts: for stiff, nearly "
       "incompressible or slender bodies",
       make_direct},
  };
  return rows;
}

std::unique_ptr<LinearSolver> make_solver(const std::string& name) {
  return find_row(solvers(), "solver", name).make();
}

}  // namespace prosector::soft
