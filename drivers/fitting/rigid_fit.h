#pragma once
// Where a device stands in the room, from points touched with it.
//
// Points a_i in the device's frame are matched with points b_i in the room. The rotation R and shift t
// minimise Σ |R a_i + t − b_i|², without scale (Umeyama 1991, by Eigen::umeyama).
//
// How good it is, after Fitzpatrick, West and Maurer 1998:
//   FRE² = 1/N Σ |R a_i + t − b_i|²      what is left over at the points themselves
//   FLE² = FRE² / (1 − 2/N)              how far a touched point is off, all three axes together
//   TRE²(x) = FLE²/N · (1 + 1/3 Σ_k d_k²/f_k²)
// Here d_k is the distance of x from the points' principal axis k, and f_k the RMS distance of the points
// from it. FRE alone says little about how far off a target is.

#include <array>
#include <span>
#include <vector>

#include "common/math.h"

namespace prosector {

/// A point as the device sees it, and where it is known to be; metres.
struct TouchedPoint {
  Vec3 device;
  Vec3 room;
};

inline constexpr std::size_t least_touched_points = 3;
inline constexpr double least_point_spread =
    0.03;  // m: RMS distance from the line that is closest to all points

struct RigidFit {
  Pose room_device;               // device frame in the room
  double fre = 0;                 // m, RMS
  double fle = 0;                 // m, RMS of a touched point
  std::vector<double> residuals;  // m, of each point
  std::size_t points = 0;
  Vec3 centre = Vec3::Zero();    // of the points, room
  Mat3 axes = Mat3::Identity();  // principal axes of the points, columns, room
  Vec3 spread = Vec3::Zero();    // m: RMS distances of the points from these axes

  /// Returns the RMS error that is expected at a target in the room, m, where touched points are off by
  /// `fle_m`.
  double expected_error(const Vec3& target, double fle_m) const;
  double expected_error(const Vec3& target) const { return expected_error(target, fle); }
};

/// Fits. Throws InputError that says what to do where there are too few points, or all lie close to a line.
RigidFit fit_rigid(std::span<const TouchedPoint> points);

}  // namespace prosector
