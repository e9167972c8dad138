#pragma once
// Tubes around curves.

#include <span>

#include "common/curves/nurbs_curve.h"
#include "common/mesh.h"

namespace prosector {

/// Returns, for each place along a curve, a unit vector across it that turns about the curve as little as it
/// can. Uses the double reflection method (Wang, Jüttler, Zheng, Liu, Computation of rotation minimizing
/// frames, ACM Trans. Graph. 27, 2008). Its error falls with the fourth power of the step. `tangents` are
/// unit; `first` is across the first one.
std::vector<Vec3> rotation_minimising_sides(std::span<const Vec3> places, std::span<const Vec3> tangents,
                                            const Vec3& first);

/// Makes a closed surface: all points at `diameter`/2 from the curve, across it, within `tolerance` (m) of
/// the true tube wherever the curve's radius of curvature is above the tube's. Flat ends; a curve that closes
/// smoothly makes a ring, whose sides are turned evenly until they meet. Throws InputError for a curve
/// without length and where `tolerance` takes too many triangles.
TriangleMesh tube_around(const NurbsCurve& curve, double diameter, double tolerance);

/// Returns as many places along the curve as make pieces of about `length` m, equally long along it (two at
/// least).
std::vector<Vec3> evenly_along(const NurbsCurve& curve, double length);

}  // namespace prosector
