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

namespace prosector {

class BodyHessian {
 public:
  /// Allocates memory for the scene's solver. `system` and `elements` must outlive this object.
  BodyHessian(const SoftSystem& system, StageElements& elements);
  /// Updates the object for the present system; equals a rebuild.
  void fit();

  /// Begins a stage, also of the elements. `start`: 3n, m, must outlive the stage.
  void begin_stage(const VecX& start, const StageWeights& weights);

  /// Assembles the matrix at x, projected to be positive definite.
  void assemble(const Eigen::Ref<const VecX>& x);
  /// Assembles the matrix at x, or uses an available approximation that still gives a descent direction.
  /// Returns whether an approximation is used.
  bool assemble_roughly(const Eigen::Ref<const VecX>& x);

  void multiply(const double* p, double* Hp) const;             // 3n each
  std::span<const Mat3> diagonal() const { return diagonal_; }  // n
  /// Computes z = H⁻¹·r by sparse Cholesky; factors at the first call after an assembly.
  void factor_solve(const double* r, double* z);
  /// Computes z ≈ H⁻¹·r by a V-cycle. `diagonal` and `inverse`: diagonal blocks with contributions of
  /// everything that touches the body, unchanged until the next assembly.
  void multigrid_solve(std::span<const Mat3> diagonal, std::span<const Mat3> inverse, const double* r,
                       double* z);

  /// Returns whether single precision is sufficient for matrices with these weights.
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

}  // namespace prosector
