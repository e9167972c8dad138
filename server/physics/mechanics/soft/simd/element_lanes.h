#pragma once
// Elements in batches with one array per matrix entry, so that one instruction processes several elements.

#include <cstddef>

namespace prosector::soft {

inline constexpr std::size_t elements_per_batch = 64;

/// 3×3 matrix for each of the 64 elements of a SIMD batch. Row k of the array has entry k (column-major) of
/// all elements.
struct alignas(64) LaneMatrix {
  double at[9][elements_per_batch];
};

/// Constant data of a SIMD batch of linear tetrahedra: shape gradients, volumes and Lamé constants. Unused
/// elements of the last batch have identity gradients and zero volume.
struct LaneRest {
  LaneMatrix gradients;                                                   // columns b_1, b_2, b_3, 1/m
  alignas(64) double volume[elements_per_batch];                          // m³
  alignas(64) double lambda[elements_per_batch], mu[elements_per_batch];  // Pa
};

/// Deformation of a SIMD batch of elements: deformation gradients F, their rotations R from the polar
/// decomposition F = R·S (polar.h), and the external pressures.
struct LaneStrain {
  LaneStrain() {}  // NOLINT: F and R are undefined until set
  LaneMatrix F, R;
  alignas(64) double pressure[elements_per_batch] = {};  // Pa
};

}  // namespace prosector::soft
