#pragma once
// Edges where cuts meet a tissue's outer surface: the line of a cut, on either of its sides.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "common/mesh.h"

namespace prosector {

/// An edge of a surface on the rim of a cut.
struct CutRim {
  std::uint32_t a = 0, b = 0;  // vertices
};

/// Returns the edges between cut faces and the outer surface. If there are no cut faces, returns the edges
/// with only one triangle: a sheet's border, which includes the sides of its cuts. Where a sheet's front and
/// back coincide, only one of the edges is returned.
std::vector<CutRim> cut_rims(const TriangleMesh& rest);

/// End points of an edge at rest, m.
struct RestEdge {
  Vec3 a, b;
};

/// The point opposite an edge's midpoint on the other side of the cut.
struct OtherSide {
  std::size_t edge = 0;
  double share = 0.5;  // position on the opposite edge, 0 at its a, 1 at its b
};

/// Returns, for each edge, the edge at the same rest position: the other side of the cut. It has the same end
/// points, or overlaps on the same line if a later cut has split one of them. nullopt: there is none.
std::vector<std::optional<OtherSide>> other_sides(const std::vector<RestEdge>& edges);

}  // namespace prosector
