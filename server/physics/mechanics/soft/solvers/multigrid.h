#pragma once
// One multigrid V-cycle as a preconditioner of a soft body's matrix H = s·(K(x) + α·M) + attachments +
// contacts' diagonal blocks.
//
// The finest level smooths with the present H: fourth-kind Chebyshev polynomials (Lottes 2023, "Optimal
// polynomial smoothers for multigrid V-cycles") in D⁻¹H, D its diagonal blocks. The coarse levels
// (smoothed_aggregation.h) are those of the rest shape, computed once per topology. The residual is rotated
// back by each node's rotation before they are applied. With one rotation R for the whole body, RᵀK(x)R is
// the matrix at rest, and for slowly varying rotations nearly so.
//
// For quadratic elements the stars of vertices (star_patches.h) correct the same residual in addition. Both
// are stored as separate contributions of K and M, so another time step only changes their sum. The
// preconditioner is symmetric and positive definite for any shape. It works in single precision, with bitwise
// equal results for any number of threads, and allocates no memory after construction.

#include <memory>
#include <span>

#include "server/physics/mechanics/soft/matrices/symmetric_product.h"
#include "server/physics/mechanics/soft/solvers/rest_system.h"

namespace prosector::soft {

class Multigrid {
 public:
  explicit Multigrid(const RestSystem& rest);
  ~Multigrid();

  /// Sets the factor α (1/s²) of the mass matrix M in the coarse levels' matrices K + α·M, where K is the
  /// stiffness. Recomputes them if α changed.
  void retime(double inertia);
  /// Computes each node's best-fit rotation from the rest shape to node positions `x` (3n, m). Residuals are
  /// rotated back by it before the coarse levels, which are those of the rest shape. Null: no rotation.
  void turn(const double* x);
  /// Sets the body's matrix H for the finest level. `off_diagonal`: H's off-diagonal blocks divided by
  /// `scale`, which must remain valid until the next call. `diagonal`: H's diagonal blocks including
  /// contacts; `inverse`: their inverses.
  void set_matrix(const SymmetricBlocks& off_diagonal, double scale, std::span<const Mat3> diagonal,
                  std::span<const Mat3> inverse);
  /// Computes z ≈ H⁻¹·r (3n values each) by one multigrid V-cycle for the matrix H of set_matrix().
  void apply(const double* r, double* z);

  std::size_t levels() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace prosector::soft
