#pragma once
// Elements in batches with one array per matrix entry, so that one instruction processes several elements.

#include <cstddef>

namespace prosector {

inline constexpr std::size_t elements_per_batch = 64;

/// A 3×3 matrix for each element of a batch: rows are the entries (column-major), columns the elements.
struct alignas(64) LaneMatrix {
  double at[9][elements_per_batch];
};

/// Constant data of a batch. Unused elements of the last batch have gradients I and zero volume.
struct LaneRest {
  LaneMatrix gradients;                                                   // columns b_1, b_2, b_3, 1/m
  alignas(64) double volume[elements_per_batch];                          // m³
  alignas(64) double lambda[elements_per_batch], mu[elements_per_batch];  // Pa
};

/// F = R·S, see polar.h, and the external pressure.
struct LaneStrain {
  LaneStrain() {}  // NOLINT: F and R are undefined until set
  LaneMatrix F, R;
  alignas(64) double pressure[elements_per_batch] = {};  // Pa
};

}  // namespace prosector
