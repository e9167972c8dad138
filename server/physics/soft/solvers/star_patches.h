#pragma once
// The matrix at rest around each vertex of quadratic elements, inverted as a whole. That is additive Schwarz
// on the stars of vertices, after Schöberl: Multigrid methods for a parameter dependent problem in primal
// variables, Numerische Mathematik 84 (1999).
//
// Nearly incompressible tissue hardly resists what leaves each element its volume. Node by node nothing does:
// every node alone changes the volumes around it, so smoothing sees the stiffness of volume alone. Together
// the nodes of a vertex and of its edges can move so.

#include <memory>

#include "server/physics/soft/solvers/rest_system.h"

namespace prosector {

class StarPatches {
 public:
  /// Takes a body of quadratic tetrahedra.
  explicit StarPatches(const RestSystem& rest);
  ~StarPatches();

  /// Sets α, 1/s², of the matrix K + α·M + attachments.
  void retime(double inertia);
  /// Adds z += share·Σ Aᵥ⁻¹r over the vertices' stars, 3n each. The same bits for any number of threads;
  /// allocates nothing.
  void add(float share, const float* r, float* z);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace prosector
