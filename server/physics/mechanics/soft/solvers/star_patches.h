#pragma once
// Additive Schwarz preconditioner on the stars of vertices of quadratic elements: inverts the rest matrix of
// each star exactly. After Schöberl: Multigrid methods for a parameter dependent problem in primal variables,
// Numerische Mathematik 84 (1999).
//
// Nearly incompressible tissue hardly resists motions that preserve each element's volume. A single node has
// no such motion, since it changes the volumes around it, so node-wise smoothing meets only the volumetric
// stiffness. The nodes of a vertex and of its edges together have such motions.

#include <memory>

#include "server/physics/mechanics/soft/solvers/rest_system.h"

namespace prosector {

class StarPatches {
 public:
  /// Takes a body of quadratic tetrahedra.
  explicit StarPatches(const RestSystem& rest);
  ~StarPatches();

  /// Sets α, 1/s², of the matrix K + α·M + attachments.
  void retime(double inertia);
  /// Adds z += share·Σ Aᵥ⁻¹r over the vertices' stars, 3n each. Bitwise equal for any number of threads;
  /// allocates no memory.
  void add(float share, const float* r, float* z);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace prosector
