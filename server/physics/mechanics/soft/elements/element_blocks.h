#pragma once
// Stiffness blocks of elements in single precision, from the tangents at their integration points
// (point_tangents.h), with the widest vectors that the CPU supports.

#include <span>

#include "server/physics/mechanics/soft/elements/corotated_elements.h"
#include "server/physics/mechanics/soft/elements/point_tangents.h"

namespace prosector::soft {

/// Floats of an element's blocks: 9, column-major, for each pair of its nodes a < b, in the order of
/// Connectivity::pair_index.
inline constexpr std::size_t floats_per_tet4 = 9 * 6, floats_per_tet10 = 9 * 45;

/// Computes the stiffness blocks (N/m) of the batch's first linear elements; each element is one point.
/// `blocks`: floats_per_tet4 per element.
void lane_tet4_blocks(const PointTangents& points, std::span<float> blocks);

/// Computes the stiffness blocks (N/m) of the batch's first quadratic elements; each element has four
/// consecutive points. `mean_share`: √(λ''/4μ) of each element, with the part λ'' of its bulk stiffness that
/// acts on the mean dilatation (Pa); empty: none has one. `share`: of the tangent in the blocks, as in
/// lane_point_tangents(). `blocks`: floats_per_tet10 per element.
void lane_tet10_blocks(const PointTangents& points, std::span<const double> mean_share, double share,
                       std::span<float> blocks);

/// Writes the points as rotated elements (corotated_elements.h) for damping: four gradients per point, and
/// λ/μ in its twist, whose T is not set.
void turned_points(const PointTangents& points, std::span<CorotatedVector> gradients,
                   std::span<Twist> twists);
/// Writes the rotated fibres (corotated_elements.h) of the points.
void turned_fibers(const PointTangents& points, std::span<CorotatedVector> fibers);

}  // namespace prosector::soft
