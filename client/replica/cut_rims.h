#pragma once
// Edges where cuts meet a tissue's outer surface: the line of a cut, on either of its sides.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "common/mesh.h"

namespace prosector {

/// Edge of a tissue's surface mesh on the rim of a cut, by its two vertex indices.
struct CutRim {
  std::uint32_t a = 0, b = 0;  // vertices
};

/// Returns the mesh edges between cut faces and the outer surface. If there are no cut faces, the mesh is a
/// sheet: returns the edges with only one triangle, which are its border including the sides of its cuts.
/// Where a sheet's front and back coincide, only one of their two edges is returned.
std::vector<CutRim> cut_rims(const TriangleMesh& rest);

/// End points of a rim edge in the rest shape, m.
struct RestEdge {
  Vec3 a, b;
};

/// Point on the opposite rim of a cut that coincided with the midpoint of an edge before the cut.
struct OtherSide {
  std::size_t edge = 0;
  double share = 0.5;  // position on the opposite edge, 0 at its a, 1 at its b
};

/// Returns, for each rim edge, the edge at the same rest position on the other side of the cut. That edge has
/// the same end points, or overlaps on the same line if a later cut has split one of them. Returns nullopt
/// for an edge without an opposite one.
std::vector<std::optional<OtherSide>> other_sides(const std::vector<RestEdge>& edges);

}  // namespace prosector
