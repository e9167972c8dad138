#pragma once
// Elements in batches, one array per matrix entry, so that one instruction works on several elements.

#include <cstddef>

namespace prosector {

inline constexpr std::size_t elements_per_batch = 64;

/// A 3×3 matrix of every element of a batch: rows are its entries (column-major), columns the elements.
struct alignas(64) LaneMatrix {
  double at[9][elements_per_batch];
};

/// What never changes. Unused elements of the last batch have gradients I and no volume.
struct LaneRest {
  LaneMatrix gradients;                                                   // columns b_1, b_2, b_3, 1/m
  alignas(64) double volume[elements_per_batch];                          // m³
  alignas(64) double lambda[elements_per_batch], mu[elements_per_batch];  // Pa
};

/// F = R·S, see polar.h; and the pressure from outside.
struct LaneStrain {
  LaneStrain() {}  // NOLINT: F and R are anything until set
  LaneMatrix F, R;
  alignas(64) double pressure[elements_per_batch] = {};  // Pa
};

}  // namespace prosector
