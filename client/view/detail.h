#pragma once
// Levels of detail: coarser triangle lists over the vertices of a mesh, which deform with it. The error of
// each list can be computed for the deformed surface.

#include "client/view/edge_collapse.h"

namespace prosector {

struct CoarserList {
  /// Vertex of the full mesh that no triangle of a coarser list uses, and the point on one of these triangles
  /// that replaces it.
  struct OmittedVertex {
    std::uint32_t vertex, triangle;
    std::array<float, 2> weights;  // of the triangle's second and third corner
    float width;                   // m at rest: width over which an error of its normal is visible
  };
  Triangles triangles;
  std::vector<OmittedVertex> left_out;
};

/// Levels of detail of a mesh: coarser triangle lists over its vertices. Each has about half the triangles of
/// the one before it; the first has about half the triangles of the mesh.
struct Detail {
  std::vector<CoarserList> coarser;
};

/// Minimum number of triangles for levels of detail. Smaller meshes are always drawn in full.
inline constexpr std::size_t min_detail_triangles = 256;

/// Computes the levels of detail (coarser triangle lists) of a surface, from its positions at rest. Takes
/// some seconds for a million triangles.
Detail make_detail(std::span<const Eigen::Vector3f> rest, const Triangles& triangles);

/// Returns the visual error of a coarser triangle list for the deformed surface, m. It bounds the distance
/// from each omitted vertex to its replacement point, and so to the coarser surface. A deviation of a normal
/// counts as a bump as high as the deviation times the omitted vertex's `width`. Errors above `enough` may be
/// returned as any value above `enough`, which saves time.
double error_of(const CoarserList& list, std::span<const Eigen::Vector3f> positions,
                std::span<const Eigen::Vector3f> normals, double enough);

}  // namespace prosector
