#pragma once
// Where the tip of an instrument is in its receiver's frame, from turning the instrument about its resting
// tip.
//
// With the receiver's poses (R_i, p_i), the tip t in its frame and the pivot c that the tip rests on:
//   R_i t + p_i = c, so [R_i −I] [t; c] = −p_i, solved for all i by least squares.
// The error that is expected of t is s² times the normal matrix' inverse, its block of t:
//   (N·I − (ΣR_i)ᵀ(ΣR_i)/N)⁻¹, s² = Σ|residual|² / (3N − 6).
// Where the receiver hardly turned, that matrix is nearly singular: the smallest eigenvalue over N is the
// mean square of the sine by which it turned in the worst direction. (Yaniv 2015 compares ways to do this.)

#include <span>

#include "common/math.h"

namespace prosector {

inline constexpr std::size_t least_pivot_poses = 20;
inline constexpr double least_pivot_turn = 0.06;     // rad, RMS in the worst direction: a cone of about ±7°
inline constexpr double most_pivot_residual = 5e-3;  // m, RMS; beyond it the tip did not rest

struct PivotFit {
  Vec3 tip = Vec3::Zero();    // m, receiver's frame
  Vec3 pivot = Vec3::Zero();  // m, frame of the poses
  double residual = 0;        // m, RMS of R_i t + p_i − c
  double tip_error = 0;       // m, RMS, expected
  double turn = 0;            // rad, RMS in the worst direction
  std::size_t poses = 0;
};

/// Fits. Throws InputError that says what to do where there are too few poses, they were hardly turned, or
/// the tip slipped.
PivotFit fit_pivot(std::span<const Pose> poses);

}  // namespace prosector
