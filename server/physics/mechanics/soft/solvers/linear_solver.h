#pragma once
// Solvers for the symmetric positive definite system of an island: soft nodes (3×3 blocks) and rigid bodies
// (6×6 blocks).

#include <memory>
#include <string>
#include <vector>

#include "common/math.h"

namespace prosector::soft {

/// System matrix H of an island as the linear solvers see it: its products with vectors and several
/// preconditioners. Unknowns are first the island's soft nodes (3 each), then its rigid bodies (6 each).
class LinearOperator {
 public:
  virtual ~LinearOperator() = default;
  virtual Eigen::Index size() const = 0;
  virtual void multiply(const VecX& p, VecX& Hp) const = 0;
  /// Computes z = P⁻¹·r, where P is the block-diagonal part of the system matrix (3×3 blocks of soft nodes
  /// and 6×6 blocks of rigid bodies, contacts included).
  virtual void block_jacobi(const VecX& r, VecX& z) const = 0;
  /// Computes z = A⁻¹·r. A consists of the soft bodies' matrices without contacts, factored exactly, and is
  /// block-diagonal for rigid bodies. The numeric factorisation is done when first needed; the symbolic one
  /// is reused.
  virtual void elastic_factor(const VecX& r, VecX& z) const = 0;
  /// Applies a preconditioner to the residual r and stores the result in z: one multigrid V-cycle for each
  /// soft body, with contacts included as diagonal blocks. Rigid bodies use their diagonal blocks.
  virtual void multigrid(const VecX& r, VecX& z) const = 0;
};

struct SolverSettings {
  int max_iterations = 60;
  double tolerance = 1e-3;  // of ‖b − Hx‖/‖b‖ in the preconditioner's norm √(vᵀP⁻¹v)
};

struct SolveReport {
  int iterations = 0;
  double residual = 0;  // relative residual of the returned x, up to rounding; infinity: not finite, x is 0
  bool converged = false;
};

class LinearSolver {
 public:
  virtual ~LinearSolver() = default;
  /// Solves H·x = b approximately, up to the tolerance or the number of iterations in `settings`. `x`: on
  /// entry the initial guess, of b's size; on return the solution. Equal inputs give bitwise equal results.
  /// Allocates memory only when the size changes.
  virtual SolveReport solve(const LinearOperator& H, const VecX& b, const SolverSettings& settings,
                            VecX& x) = 0;
};

struct SolverRow {
  const char* name;
  const char* help;
  std::unique_ptr<LinearSolver> (*make)();
};
const std::vector<SolverRow>& solvers();
/// Creates the linear solver with this name. Throws InputError that lists the known names if there is none.
std::unique_ptr<LinearSolver> make_solver(const std::string& name);

}  // namespace prosector::soft
