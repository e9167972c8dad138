#pragma once
// Hessian of one soft body's potential, without other bodies, with products and solves. Stored in double
// precision as blocks, or in single precision as symmetric rows, as the stage's solver and weights require.
// The other form is computed when needed.

#include <memory>
#include <span>
#include <vector>

#include "server/physics/mechanics/soft/solvers/cholesky.h"
#include "server/physics/mechanics/soft/solvers/multigrid.h"
#include "server/physics/mechanics/soft/stage_elements.h"

namespace prosector::soft {

class BodyHessian {
 public:
  /// Initialises the Hessian for the equations of `system` and allocates memory for the linear solver that
  /// the scene names. `system` and `elements` must outlive this object.
  BodyHessian(const SoftSystem& system, StageElements& elements);
  /// Adapts the Hessian after the body's mesh or masses changed: resizes all arrays and discards computed
  /// matrices. The result equals that of a newly built object.
  void fit();

  /// Begins a stage (one minimisation of an implicit step), also in the body's elements. `start`: node
  /// positions at the step's start (3n, m), which must outlive the stage. `weights`: factors of inertia and
  /// damping in the Hessian.
  void begin_stage(const VecX& start, const StageWeights& weights);

  /// Computes the body's Hessian (inertia, elements, attachments and damping) at node positions x (3n, m).
  /// The elements' tangents are projected, so that the matrix is positive definite.
  void assemble(const Eigen::Ref<const VecX>& x);
  /// Computes the Hessian at node positions x (3n, m), or uses a cheaper approximation for nearby positions
  /// that still gives a descent direction. Returns true if it uses the approximation.
  bool assemble_roughly(const Eigen::Ref<const VecX>& x);

  void multiply(const double* p, double* Hp) const;             // 3n each
  std::span<const Mat3> diagonal() const { return diagonal_; }  // n
  /// Computes z = H⁻¹·r (3n each) by sparse Cholesky factorisation of the Hessian H. Factors H at the first
  /// call after it was assembled.
  void factor_solve(const double* r, double* z);
  /// Computes z ≈ H⁻¹·r (3n each) by one multigrid V-cycle. `diagonal`: H's 3×3 diagonal blocks by node,
  /// including the stiffness of all contacts and ties of the body; `inverse`: their inverses. Both must stay
  /// unchanged until the next assembly.
  void multigrid_solve(std::span<const Mat3> diagonal, std::span<const Mat3> inverse, const double* r,
                       double* z);

  /// Returns whether the Hessian can be stored in single precision. Requires a body with rotated elements or
  /// the multigrid solver, no direct solver, and inertia of at least 1e-5 of the stiffness for these weights.
  bool single_will_do(const StageWeights& weights) const;

 private:
  std::size_t nodes() const { return diagonal_.size(); }
  bool turns() const { return system_.model.turns(); }
  void make_coarse_levels();
  void assemble_warped(const Eigen::Ref<const VecX>& x);
  void take_blocks();
  void take_rows();
  template <class F>
  void add_diagonal(const F& of_elements);
  void blocks_from_rows();
  void rows_from_blocks();

  SoftSystem system_;
  StageElements& elements_;
  StageWeights weights_;
  const VecX* start_ = nullptr;
  double rest_stiffness_ = 0;  // N/m: mean of the diagonal in the rest shape
  bool single_ = false;

  // The matrix is blocks_ in double, or scale()·(off-diagonal blocks of rows_) and diagonal_. Rotated
  // elements are assembled into rows_ directly; other elements, and solver `direct`, use blocks_.
  std::vector<Mat3> blocks_;  // of the pattern; allocated when first used
  SymmetricRows rows_;
  std::vector<Mat3> diagonal_;
  bool blocks_known_ = false, rows_known_ = false;  // whether they hold the last assembly
  std::unique_ptr<Cholesky> cholesky_;
  bool factored_ = false;
  std::unique_ptr<Multigrid> multigrid_;
  bool multigrid_set_ = false, multigrid_turned_ = false;
};

}  // namespace prosector::soft
