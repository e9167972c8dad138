#pragma once
// Preconditioned conjugate gradients (Hestenes & Stiefel 1952; Saad 2003, alg. 9.1).

#include "server/physics/mechanics/soft/solvers/linear_solver.h"

namespace prosector {

/// Creates conjugate gradients preconditioned with H's diagonal blocks.
std::unique_ptr<LinearSolver> make_cg();

/// Creates conjugate gradients preconditioned with the exact factorisation of the soft bodies' elastic
/// matrices. It takes one iteration without contacts, and about one more for each coupling contact direction.
std::unique_ptr<LinearSolver> make_direct();

/// Creates conjugate gradients preconditioned with one multigrid V-cycle for each soft body. It takes about
/// ten iterations, independent of the mesh size.
std::unique_ptr<LinearSolver> make_multigrid();

}  // namespace prosector
