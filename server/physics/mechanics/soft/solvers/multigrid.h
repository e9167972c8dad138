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

namespace prosector {

class Multigrid {
 public:
  explicit Multigrid(const RestSystem& rest);
  ~Multigrid();

  /// Sets the coarse levels' α, 1/s².
  void retime(double inertia);
  /// Rotates the coarse levels to the node positions `x`, 3n; null: no rotation.
  void turn(const double* x);
  /// Sets the matrix. `off_diagonal`: H's off-diagonal blocks times 1/s, which must remain valid until the
  /// next call. `diagonal`: its diagonal blocks with contacts; `inverse`: the inverses of these.
  void set_matrix(const SymmetricBlocks& off_diagonal, double scale, std::span<const Mat3> diagonal,
                  std::span<const Mat3> inverse);
  /// Computes z ≈ H⁻¹·r, 3n each.
  void apply(const double* r, double* z);

  std::size_t levels() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace prosector
