#include "server/physics/mechanics/soft/solvers/linear_solver.h"

#include "server/physics/mechanics/soft/base/find_row.h"
#include "server/physics/mechanics/soft/solvers/conjugate_gradient.h"

namespace prosector {

const std::vector<SolverRow>& solvers() {
  static const std::vector<SolverRow> rows = {
      {"cg", "conjugate gradients, block Jacobi: little work for little accuracy", make_cg},
      {"multigrid", "conjugate gradients, multigrid: few iterations, however fine the mesh", make_multigrid},
      {"direct", "sparse Cholesky, refined over contacts: stiff, nearly incompressible or slender bodies",
       make_direct},
  };
  return rows;
}

std::unique_ptr<LinearSolver> make_solver(const std::string& name) {
  return find_row(solvers(), "solver", name).make();
}

}  // namespace prosector
