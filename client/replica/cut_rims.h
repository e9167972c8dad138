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
/// edges of one triangle alone: a sheet's border, of which a cut's sides are a part. Of a sheet's front and
/// back, which are at one place, only one counts.
std::vector<CutRim> cut_rims(const TriangleMesh& rest);

/// Two ends at rest, m.
struct RestEdge {
  Vec3 a, b;
};

/// What is opposite of an edge's middle, on the other side of the cut.
struct OtherSide {
  std::size_t edge = 0;
  double share = 0.5;  // of that edge, from its a on
};

/// Returns, for each edge, the one that was at the same place at rest: the other side of the cut. It is
/// between the same places, or a part of the same line where a later cut has parted one of the two. nullopt:
/// there is none.
std::vector<std::optional<OtherSide>> other_sides(const std::vector<RestEdge>& edges);

}  // namespace prosector
