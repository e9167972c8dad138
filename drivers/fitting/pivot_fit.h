#pragma once
// Pivot calibration: the position of an instrument's tip in its receiver's frame, from rotations about the
// resting tip.
//
// With the receiver's poses (R_i, p_i), the tip t in its frame and the pivot c on which the tip rests:
//   R_i t + p_i = c, so [R_i −I] [t; c] = −p_i, solved for all i by least squares.
// The expected squared error of t is s² times the block of t of the inverse normal matrix:
//   (N·I − (ΣR_i)ᵀ(ΣR_i)/N)⁻¹, s² = Σ|residual|² / (3N − 6).
// If the receiver hardly rotated, that matrix is nearly singular. Its smallest eigenvalue over N is the mean
// square sine of the rotation about the worst direction. (Yaniv 2015 compares methods.)

#include <span>

#include "common/math.h"

namespace prosector {

inline constexpr std::size_t min_pivot_poses = 20;
inline constexpr double min_pivot_rotation = 0.06;  // rad, RMS in the worst direction: a cone of about ±7°
inline constexpr double max_pivot_residual = 5e-3;  // m, RMS; above it the tip slipped

struct PivotFit {
  Vec3 tip = Vec3::Zero();    // m, receiver's frame
  Vec3 pivot = Vec3::Zero();  // m, frame of the poses
  double residual = 0;        // m, RMS of R_i t + p_i − c
  double tip_error = 0;       // m, expected RMS
  double turn = 0;            // rad, RMS in the worst direction
  std::size_t poses = 0;
};

/// Fits an instrument's tip (in its receiver's frame) to receiver poses recorded while the instrument was
/// rotated about its resting tip. Throws InputError with advice if there are too few poses, they hardly
/// rotate, or the tip slipped.
PivotFit fit_pivot(std::span<const Pose> poses);

}  // namespace prosector
