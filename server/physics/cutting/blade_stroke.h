#pragma once
// What a stroke of the blade has to remember from tick to tick.

#include <span>
#include <vector>

#include "server/physics/cutting/tet_complex.h"

namespace prosector {

class TetTree;

/// Plain data, part of what a checkpoint has to hold. A stroke ends where the blade leaves the body for good;
/// forget it then.
struct BladeStroke {
  /// A point of the line that the blade's edge has cut to: in the room, and in the tissue where it was in
  /// some.
  struct EdgePoint {
    double at = 0;                   // along the edge, in its points: 0 is the first
    Vec3 room = Vec3::Zero();        // m
    TetId tet = TetComplex::none;    // that it was in
    std::array<double, 4> weight{};  // of its corners
    bool is_corner() const { return at == static_cast<double>(static_cast<std::size_t>(at)); }
  };
  /// A node that counts as lying on the surface swept, and that surface's plane there, at rest.
  struct Mark {
    NodeId node = 0;
    Vec3 point = Vec3::Zero();   // m
    Vec3 normal = Vec3::Zero();  // unit
  };
  /// The line from end to end: the edge's own points, and in tissue also those where the line goes through
  /// faces. So it is straight in each tetrahedron, and stays the same line in the tissue however that is
  /// bent. It has two points at one place where tetrahedra that it goes on in have no face in common.
  std::vector<EdgePoint> edge;
  std::vector<Mark> marks;    // ascending by node
  bool ended_inside = false;  // an end of the edge was in tissue since the line came into it
  Vec3 way = Vec3::Zero();    // m: of the line in tissue, in the room, in the last tick that cut

  std::size_t points() const {  // of the blade's own
    return edge.empty() ? 0 : static_cast<std::size_t>(edge.back().at) + 1;
  }
};

/// Begins a stroke. `edge`: the blade's, a polyline of at least two points in the room, metres. Throws
/// InputError.
BladeStroke begin_stroke(std::span<const Vec3> edge);

/// Returns where the stroke's line would be now had it moved along with the tissue it was in. Points beside
/// tissue start farther behind where the blade's edge is now (`edge`), by what the nearest tissue of the line
/// moved since. What may have come over them they go through again, from outside.
std::vector<Vec3> carried_edge(const BladeStroke& stroke, std::span<const Vec3> edge,
                               const TetComplex& complex, std::span<const Vec3> positions);

/// Where the line goes on to as the blade's edge goes to `edge`. What would move less than `least_motion`, m,
/// stands still.
struct MovedEdge {
  std::vector<Vec3> to;
  std::vector<std::uint8_t> stands;  // by point
};
MovedEdge moved_edge(const BladeStroke& stroke, std::span<const Vec3> from, std::span<const Vec3> edge,
                     double least_motion);

/// Remembers the line, in the tissue; beside a sheet, which has no inside, in the room. `tree` may date from
/// before the last splits.
void hold_edge(BladeStroke& stroke, const MovedEdge& moved, const TetComplex& complex, const TetTree& tree,
               std::span<const Vec3> positions);

/// Throws InputError for fewer than two points and numbers that aren't finite.
void check_edge(std::span<const Vec3> edge);

}  // namespace prosector
