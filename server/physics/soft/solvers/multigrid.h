#pragma once
// One V-cycle of multigrid as a preconditioner of a soft body's matrix H = s·(K(x) + α·M) + attachments +
// contacts' diagonal blocks.
//
// The finest level smooths with H as it is: Chebyshev polynomials of the fourth kind (Lottes 2023, "Optimal
// polynomial smoothers for multigrid V-cycles") in D⁻¹H, D its diagonal blocks. The coarse levels
// (smoothed_aggregation.h) are those of the rest shape, once per topology, and see the residual turned back
// by each node's rotation. With one rotation R for the whole body, RᵀK(x)R is the matrix at rest, and where
// rotations vary slowly, nearly so. Of quadratic elements the stars of vertices (star_patches.h) correct the
// same residual beside them. Both are kept as parts that K and M contribute, so that another time step only
// adds these up anew. Symmetric and positive definite, whatever the shape. Float inside; the same bits for
// any number of threads; nothing allocates after the constructor.

#include <memory>
#include <span>

#include "server/physics/soft/matrices/symmetric_product.h"
#include "server/physics/soft/solvers/rest_system.h"

namespace prosector {

class Multigrid {
 public:
  explicit Multigrid(const RestSystem& rest);
  ~Multigrid();

  /// Sets the coarse levels' α, 1/s².
  void retime(double inertia);
  /// Turns the coarse levels with the nodes of `x`, 3n; null: as at rest.
  void turn(const double* x);
  /// Sets the matrix: H's off-diagonal blocks times 1/s, to be kept until the next call; its diagonal ones
  /// with contacts; the inverses of these.
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
