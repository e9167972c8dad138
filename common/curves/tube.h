#pragma once
// Tube surfaces around curves.

#include <span>

#include "common/curves/nurbs_curve.h"
#include "common/mesh.h"

namespace prosector {

/// Returns, for each position along a curve, a unit vector perpendicular to the curve, of a
/// rotation-minimising frame. Uses the double reflection method (Wang, Jüttler, Zheng, Liu, Computation of
/// rotation minimizing frames, ACM Trans. Graph. 27, 2008). The error decreases with the fourth power of the
/// step. `tangents` are unit vectors; `first` is perpendicular to the first one.
std::vector<Vec3> rotation_minimising_sides(std::span<const Vec3> places, std::span<const Vec3> tangents,
                                            const Vec3& first);

/// Builds a closed tube of `diameter` (m) around the curve. It is within `tolerance` (m) of the exact tube
/// where the curve's radius of curvature exceeds the tube's radius. Ends are flat. A smoothly closed curve
/// gives a ring, whose frames are twisted evenly until they match. Throws InputError for a curve without
/// length, or if `tolerance` needs too many triangles.
TriangleMesh tube_around(const NurbsCurve& curve, double diameter, double tolerance);

/// Returns positions along the curve that divide it into segments of equal arc length of about `length` m (at
/// least two positions).
std::vector<Vec3> equidistant_points(const NurbsCurve& curve, double length);

}  // namespace prosector
