#pragma once
// Preconditioned conjugate gradients (Hestenes & Stiefel 1952; Saad 2003, alg. 9.1).

#include "server/physics/mechanics/soft/solvers/linear_solver.h"

namespace prosector::soft {

/// Creates a conjugate-gradient solver preconditioned with the inverses of the system matrix's diagonal
/// blocks (block Jacobi).
std::unique_ptr<LinearSolver> make_cg();

/// Creates a conjugate-gradient solver preconditioned with exact factorisations of the soft bodies' matrices
/// without contacts. It takes one iteration without contacts, and about one more for each contact direction
/// that couples bodies.
std::unique_ptr<LinearSolver> make_direct();

/// Creates a conjugate-gradient solver preconditioned with one multigrid V-cycle for each soft body. It takes
/// about ten iterations, independent of the mesh size.
std::unique_ptr<LinearSolver> make_multigrid();

}  // namespace prosector::soft
