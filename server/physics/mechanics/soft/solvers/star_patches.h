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

namespace prosector::soft {

class StarPatches {
 public:
  /// Builds the patches of a body of quadratic tetrahedra from its matrices in the rest shape: for each
  /// vertex, the vertex and the nodes on its edges.
  explicit StarPatches(const RestSystem& rest);
  ~StarPatches();

  /// Sets the factor α (1/s²) of the mass matrix M in the matrix K + α·M + attachments. Inverts the part of
  /// that matrix for each patch if α changed.
  void retime(double inertia);
  /// Adds share·Σ Aᵥ⁻¹r to z (3n values each), summed over all vertices' patches. Aᵥ is the part of the
  /// rest-shape matrix for a vertex and the nodes on its edges. Results are bitwise equal for any number of
  /// threads; allocates no memory.
  void add(float share, const float* r, float* z);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace prosector::soft
