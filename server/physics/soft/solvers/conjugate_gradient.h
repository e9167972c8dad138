#pragma once
// Preconditioned conjugate gradients (Hestenes & Stiefel 1952; Saad 2003, alg. 9.1).

#include "server/physics/soft/solvers/linear_solver.h"

namespace prosector {

/// Makes conjugate gradients preconditioned with H's diagonal blocks.
std::unique_ptr<LinearSolver> make_cg();

/// Makes conjugate gradients preconditioned with the exact factor of the soft bodies' elastic matrices: one
/// iteration without contacts, about one more for each contact direction that couples.
std::unique_ptr<LinearSolver> make_direct();

/// Makes conjugate gradients preconditioned with one multigrid V-cycle for each soft body: some ten
/// iterations, however fine the mesh.
std::unique_ptr<LinearSolver> make_multigrid();

}  // namespace prosector
