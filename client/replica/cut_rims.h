#pragma once
// Where cuts meet the outside of tissue: the line of a cut, seen from either of its sides.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "common/mesh.h"

namespace prosector {

/// An edge of a surface at which a cut may lie.
struct CutRim {
  std::uint32_t a = 0, b = 0;  // vertices
};

/// Returns the edges at which what a cut laid bare meets the outside. Where nothing is inner, they are the
/// edges of one triangle alone: a sheet's border, of which a cut's sides are a part.
std::vector<CutRim> cut_rims(const TriangleMesh& rest);

/// Two ends at rest, m.
struct RestEdge {
  Vec3 a, b;
};

/// Returns, for each edge, another one between the same places at rest: the other side of the cut.
/// nullopt: there is none.
std::vector<std::optional<std::size_t>> other_sides(const std::vector<RestEdge>& edges);

}  // namespace prosector
