#pragma once
// Tangents at the integration points of a batch, in single precision: the data from which the stiffness
// blocks of elements are computed (element_blocks.h).
//
// At a point of volume V let r_a = √(Vμ)·R·b_a, with b_a the gradient of shape function a at rest and R the
// rotation of the polar decomposition F = R·S. The eigenvectors of an isotropic law's tangent are scalings,
// flips and twists (Smith, de Goes & Kim 2019, "Analytic eigensystems for isotropic distortion energies").
// In the rotated frame, scalings and flips are symmetric matrices, and twists are antisymmetric. So the
// stiffness of nodes a and b is
//   K_ab,ij = Σ_kl D_(ik)(jl) r_a,k r_b,l + ([r_a]ₓ W [r_b]ₓᵀ)_ij
// with D symmetric in i and k, in j and l, and in the two pairs; W is a symmetric 3×3 matrix. Both are
// relative to μ. Fibres along the unit vector c, rotated, add (c·r_a)(c·r_b) Q. An element with a mean
// dilatation (mean_dilatation.h) adds g_a g_bᵀ, with g_a proportional to the sum over its points of Θ r_a. Θ
// is the derivative of the law's volume change by the strain.

#include <cstddef>

#include "server/physics/mechanics/soft/simd/element_lanes.h"

namespace prosector::soft {

/// Tangents at the points of a batch; one row per number, one column per point. Symmetric matrices are in
/// the order xx, yy, zz, xy, xz, yz.
struct alignas(64) PointTangents {
  PointTangents() {}                         // NOLINT: undefined until set
  float gradient[12][elements_per_batch];    // r_0 … r_3, √(N/m)
  float lame_ratio[elements_per_batch];      // λ/μ
  float symmetric[21][elements_per_batch];   // D: upper triangle of a symmetric 6×6 matrix, row by row
  float rotational[6][elements_per_batch];   // W
  float dilatation[6][elements_per_batch];   // Θ
  float fiber[3][elements_per_batch];        // c
  float fiber_root[elements_per_batch];      // (k/μ)^¼ of fibres of stiffness k; 0: slack
  float along_fiber[6][elements_per_batch];  // Q
  bool has_fibers = false;                   // whether the last three count

  /// Returns the row of `symmetric` that has the entry of the index pairs v ≤ w, each 0 … 5.
  static constexpr std::size_t entry(std::size_t v, std::size_t w) { return v * (11 - v) / 2 + w; }
};

}  // namespace prosector::soft
