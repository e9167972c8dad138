#pragma once
// Displacement of meshes of linear tetrahedra under a small patch of pressure, by a solver of its own.

namespace prosector::test {

/// Displacement of a mesh's surface under a load.
struct MeshYield {
  double displacement = 0;  // mean under the load, times E*·element_size/force, with E* = E/(1 − ν²)
  double spread = 0;        // Σw² of the fractions w of the force that nodes take
};

/// Presses half-spaces of stuffed tetrahedra with Hertz's pressure on a patch of that radius (cells), at
/// several places, and returns the means. Half-spaces are blocks of two sizes, extrapolated to infinity.
MeshYield yield_of_half_space(double poisson_ratio, double patch);

}  // namespace prosector::test
