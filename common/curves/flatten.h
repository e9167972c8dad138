#pragma once
// Approximation of a curve by a polyline.

#include "common/curves/nurbs_curve.h"

namespace prosector {

/// Maximum number of points of a polyline that approximates a curve.
inline constexpr std::size_t max_polyline_points = 20000;
/// Returns the curve parameters, increasing from begin() to end(), of the points of a polyline that
/// approximates the curve. The distance between both is at most `tolerance` (m), and the curve turns by at
/// most `turn` (rad) along a segment. Both bounds are guaranteed: a curve piece is within the convex hull of
/// its control points, and its tangents within the cone of the control polygon's legs. Source: Farin, Curves
/// and Surfaces for CAGD, 5th ed. 2002, ch. 4 and 13. Throws InputError if more than max_polyline_points
/// points are needed.
std::vector<double> flatten(const NurbsCurve& curve, double tolerance, double turn);

}  // namespace prosector
