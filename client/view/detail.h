#pragma once
// Levels of detail: coarser triangle lists over the vertices of a mesh, which deform with it. The error of
// each list can be computed for the deformed surface.

#include "client/view/edge_collapse.h"

namespace prosector {

struct CoarserList {
  /// A vertex that is in no triangle, and the point on one of the triangles that replaces it.
  struct OmittedVertex {
    std::uint32_t vertex, triangle;
    std::array<float, 2> weights;  // of the triangle's second and third corner
    float width;                   // m at rest: width over which an error of its normal is visible
  };
  Triangles triangles;
  std::vector<OmittedVertex> left_out;
};

/// The coarser lists of a mesh. Each has about half the triangles of the one before it; the first has about
/// half the triangles of the mesh.
struct Detail {
  std::vector<CoarserList> coarser;
};

/// Meshes with fewer triangles have no levels of detail.
inline constexpr std::size_t min_detail_triangles = 256;

/// Makes the levels of detail of a surface at rest. Takes some seconds for a million triangles.
Detail make_detail(std::span<const Eigen::Vector3f> rest, const Triangles& triangles);

/// Returns the error of the list for the deformed surface, m. It bounds the distance from each omitted vertex
/// to its replacement point, and so to the coarser surface. A deviation of a normal counts as a bump as high
/// as the deviation times `width`. `width` is half the shortest side of the triangle there, or half the width
/// of the vertex's largest triangle, whichever is more. Errors above `enough` may be returned as any value
/// above `enough`.
double error_of(const CoarserList& list, std::span<const Eigen::Vector3f> positions,
                std::span<const Eigen::Vector3f> normals, double enough);

}  // namespace prosector
