#pragma once
// A curve as a polygon that is near enough.

#include "common/curves/nurbs_curve.h"

namespace prosector {

/// The most points of a polygon.
inline constexpr std::size_t max_polygon = 20000;
/// Returns parameters, rising from begin() to end(), at which the curve's points make a polygon. It is
/// nowhere farther than `tolerance` from the curve, and along each of its pieces the curve turns by at most
/// `turn` (rad). Both hold because a piece lies in the hull of its control points, and its tangents among the
/// legs between them (Farin, Curves and Surfaces for CAGD, 5th ed. 2002, ch. 4 and 13). Throws InputError
/// where that takes more than max_polygon points.
std::vector<double> flatten(const NurbsCurve& curve, double tolerance, double turn);

}  // namespace prosector
