#pragma once
// Pose of a device in the room, from touched points.
//
// Points a_i in the device's frame are matched with points b_i in the room. The rotation R and translation t
// minimise Σ |R a_i + t − b_i|², without scale (Umeyama 1991, by Eigen::umeyama).
//
// Accuracy, after Fitzpatrick, West and Maurer 1998:
//   FRE² = 1/N Σ |R a_i + t − b_i|²      residual at the points themselves
//   FLE² = FRE² / (1 − 2/N)              error of a touched point, all three axes together
//   TRE²(x) = FLE²/N · (1 + 1/3 Σ_k d_k²/f_k²)   error at a target x.
// Here d_k is the distance of x from the points' principal axis k, and f_k the RMS distance of the points
// from it. FRE alone is no measure of the error at a target.

#include <array>
#include <span>
#include <vector>

#include "common/math.h"

namespace prosector {

/// A point that the user touched: its position in the device's frame as measured, and its known position in
/// the room; m.
struct TouchedPoint {
  Vec3 device;
  Vec3 room;
};

inline constexpr std::size_t min_touched_points = 3;
inline constexpr double min_point_spread = 0.03;  // m: RMS distance of the points from their best-fit line

struct RigidFit {
  Pose room_device;               // pose of the device's frame in the room
  double fre = 0;                 // m, RMS
  double fle = 0;                 // m, RMS error of a touched point
  std::vector<double> residuals;  // m, one per point
  std::size_t points = 0;
  Vec3 centre = Vec3::Zero();    // mean of the points, room
  Mat3 axes = Mat3::Identity();  // principal axes of the points, as columns, room
  Vec3 spread = Vec3::Zero();    // m: RMS distances of the points from these axes

  /// Returns the expected RMS error of the fitted pose at a target position (m, room frame), in m, if touched
  /// points have the RMS error `fle_m`, m.
  double expected_error(const Vec3& target, double fle_m) const;
  double expected_error(const Vec3& target) const { return expected_error(target, fle); }
};

/// Fits the device's pose in the room to touched points. Throws InputError with advice if there are too few
/// points or all lie close to a line.
RigidFit fit_rigid(std::span<const TouchedPoint> points);

}  // namespace prosector
