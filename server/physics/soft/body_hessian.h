#pragma once
// The Hessian of a soft body's potential, without the bodies around it, and the ways to multiply with it and
// to solve with it. Kept in double as blocks, or in single precision as symmetric rows, whichever the stage's
// solver and weights call for; the other is made when it is asked for.

#include <memory>
#include <span>
#include <vector>

#include "server/physics/soft/solvers/cholesky.h"
#include "server/physics/soft/solvers/multigrid.h"
#include "server/physics/soft/stage_elements.h"

namespace prosector {

class BodyHessian {
 public:
  /// Allocates all that the scene's solver needs. `system` and `elements` must outlive this.
  BodyHessian(const SoftSystem& system, StageElements& elements);
  /// Fits to the system as it is, as if made anew.
  void fit();

  /// Begins the stage, and that of the elements. `start`: 3n, m, must outlive the stage.
  void begin_stage(const VecX& start, const StageWeights& weights);

  /// Assembles the matrix at x, projected so that it is positive definite.
  void assemble(const Eigen::Ref<const VecX>& x);
  /// Assembles the matrix at x, or keeps or takes one at hand that is good to descend with; returns true
  /// then.
  bool assemble_roughly(const Eigen::Ref<const VecX>& x);

  void multiply(const double* p, double* Hp) const;             // 3n each
  std::span<const Mat3> diagonal() const { return diagonal_; }  // n
  /// Computes z = H⁻¹·r by sparse Cholesky, factored at the first call after an assembly.
  void factor_solve(const double* r, double* z);
  /// Computes z ≈ H⁻¹·r by a V-cycle; `diagonal` and `inverse`: with whatever touches the body, the same
  /// until the next assembly.
  void multigrid_solve(std::span<const Mat3> diagonal, std::span<const Mat3> inverse, const double* r,
                       double* z);

  /// Tells whether single precision is enough for matrices that are weighed so.
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
  double rest_stiffness_ = 0;  // N/m: mean of the diagonal at rest
  bool single_ = false;

  // blocks_ in double, or scale()·(off-diagonal blocks of rows_) and diagonal_. Turned elements go straight
  // into rows_; the others, and `direct`, by blocks_.
  std::vector<Mat3> blocks_;  // of the pattern; made when first used
  SymmetricRows rows_;
  std::vector<Mat3> diagonal_;
  bool blocks_known_ = false, rows_known_ = false;  // as last assembled
  std::unique_ptr<Cholesky> cholesky_;
  bool factored_ = false;
  std::unique_ptr<Multigrid> multigrid_;
  bool multigrid_set_ = false, multigrid_turned_ = false;
};

}  // namespace prosector
