#pragma once
// Solvers for the symmetric positive definite system of an island: soft nodes (3×3 blocks) and rigid bodies
// (6×6 blocks).

#include <memory>
#include <string>
#include <vector>

#include "common/math.h"

namespace prosector {

/// System matrix H as seen by the solvers. Unknowns: the island's soft nodes (3 each), then its rigid bodies
/// (6 each).
class LinearOperator {
 public:
  virtual ~LinearOperator() = default;
  virtual Eigen::Index size() const = 0;
  virtual void multiply(const VecX& p, VecX& Hp) const = 0;
  /// Computes z = P⁻¹·r with the block-diagonal part of H (3×3 and 6×6 blocks, contacts included).
  virtual void block_jacobi(const VecX& r, VecX& z) const = 0;
  /// Computes z = A⁻¹·r with A the soft bodies' elastic matrices (without contacts) factored exactly,
  /// block-diagonal elsewhere. Factors lazily, reusing the symbolic factorisation.
  virtual void elastic_factor(const VecX& r, VecX& z) const = 0;
  /// Applies one multigrid V-cycle for each soft body, with contacts as diagonal blocks; block-diagonal
  /// elsewhere.
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
  /// Improves `x` (the initial guess, of b's size) towards H·x = b. Equal inputs give bitwise equal results.
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
/// Throws InputError that lists the known names.
std::unique_ptr<LinearSolver> make_solver(const std::string& name);

}  // namespace prosector
