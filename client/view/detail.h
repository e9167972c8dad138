#pragma once
// Levels of detail: coarser lists of a mesh's triangles over the same vertices, which move as they did. How
// far each list is from the surface as it is bent now is known, too.

#include "client/view/edge_collapse.h"

namespace prosector {

struct CoarserList {
  /// A vertex that no triangle has, and the place on one of them that stands for it.
  struct LeftOut {
    std::uint32_t vertex, triangle;
    std::array<float, 2> weights;  // of the triangle's second and third corner
    float width;                   // m at rest, over which its normal shows
  };
  Triangles triangles;
  std::vector<LeftOut> left_out;
};

/// A mesh's coarser lists, each with half of the triangles of the one before, about, beginning with that of
/// the mesh.
struct Detail {
  std::vector<CoarserList> coarser;
};

/// The fewest triangles of a mesh that has levels of detail; one of fewer is drawn as it is.
inline constexpr std::size_t least_detailed = 256;

/// Makes the detail of a surface at rest. Takes some seconds for a million triangles.
Detail make_detail(std::span<const Eigen::Vector3f> rest, const Triangles& triangles);

/// Returns how far the list is from the surface as that is bent now, m. No vertex that it leaves out is
/// farther from the place that stands for it, nor so from the coarser surface. A normal that is off counts as
/// a bump as high as that times `width`. That is half of the shortest side of the triangle there or of the
/// width of the largest triangle that the vertex had, whichever is more. Returns any value above `enough`
/// where it is more than that.
double error_of(const CoarserList& list, std::span<const Eigen::Vector3f> positions,
                std::span<const Eigen::Vector3f> normals, double enough);

}  // namespace prosector
