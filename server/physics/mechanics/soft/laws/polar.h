#pragma once
// Polar decomposition of a deformation gradient.

#include "common/math.h"

namespace prosector::soft {

/// Polar decomposition F = R·S of a 3×3 matrix. R is the proper rotation closest to F (it maximises tr(RᵀF)),
/// and S is symmetric. For det F < 0 the smallest principal stretch in S is negative. With principal
/// stretches σ₁ ≥ σ₂ ≥ |σ₃|, every sum σᵢ + σⱼ is at least 0, and R is unique unless σ₂ + σ₃ = 0.
struct Polar {
  Mat3 R, S;
};

/// Returns the polar factors of F. For every finite F, also one collapsed to a plane, line or point, or
/// mirrored, R is a proper rotation up to rounding. If several rotations are closest, R is one of them. For a
/// point or a non-finite F it is the identity.
///
/// The unit quaternion of R is the eigenvector of Horn's symmetric 4×4 matrix for its largest eigenvalue,
/// σ₁+σ₂+σ₃ (Horn 1987, JOSA A 4). Newton's method finds this eigenvalue on the characteristic quartic from
/// the bound √3‖F‖ (Theobald 2005, Acta Cryst. A61). The eigenvector is then a column of the adjugate. If the
/// two largest eigenvalues nearly coincide, an orthogonal eigensolver is used instead.
Polar polar(const Mat3& F);

}  // namespace prosector::soft
