#pragma once
// State of a blade stroke that is stored from tick to tick.

#include <span>
#include <vector>

#include "server/physics/mechanics/cutting/tet_complex.h"

namespace prosector::cutting {

class TetTree;

/// State of a blade's stroke through a body: the line up to which the blade has cut, and the nodes on the
/// swept surface. It is plain data, stored in checkpoints. A stroke ends when the blade has left the body for
/// good; discard the state then.
struct BladeStroke {
  /// Point of the stroke's line, up to which the blade's edge has cut. It is stored in the world frame. If
  /// the point is in tissue, it is also stored by its tetrahedron and barycentric weights, so that it moves
  /// with the tissue.
  struct EdgePoint {
    double at = 0;                   // position along the edge, in points of the edge: 0 is the first
    Vec3 room = Vec3::Zero();        // m, world frame
    TetId tet = TetComplex::none;    // the tetrahedron that contains the point
    std::array<double, 4> weight{};  // barycentric, of the tetrahedron's corners
    bool is_corner() const { return at == static_cast<double>(static_cast<std::size_t>(at)); }
  };
  /// Node that counts as lying on the swept surface, with the plane of this surface at the node, in the
  /// body's rest shape.
  struct Mark {
    NodeId node = 0;
    Vec3 point = Vec3::Zero();   // m
    Vec3 normal = Vec3::Zero();  // unit
  };
  /// The stroke's line from end to end: the points of the blade's edge and, in tissue, the points at which
  /// the line crosses faces of tetrahedra. The line is straight within each tetrahedron, so it stays the same
  /// line in the tissue under any deformation. It has two points at the same position if it continues in a
  /// tetrahedron without a common face.
  std::vector<EdgePoint> edge;
  std::vector<Mark> marks;    // ascending by node
  bool ended_inside = false;  // whether an end of the edge was in tissue since the line entered the tissue
  Vec3 way = Vec3::Zero();    // m, world frame: mean motion of the line in tissue in the last tick that cut

  std::size_t points() const {  // number of points of the blade's edge
    return edge.empty() ? 0 : static_cast<std::size_t>(edge.back().at) + 1;
  }
};

/// Returns the state of a stroke that begins with the blade's edge `edge`, a polyline of at least two points,
/// m, world frame. Throws InputError for fewer points and for numbers that are not finite.
BladeStroke begin_stroke(std::span<const Vec3> edge);

/// Returns the current positions, m, of the points of the stroke's line: the blade's edge as last stored in
/// the stroke, moved with the tissue since. `positions`: node positions, m, by node id.
///
/// Points in tissue follow it. Points outside tissue are moved farther behind the blade's current `edge`, by
/// the motion of the nearest point of the line that is in tissue. So they sweep again, from outside, through
/// tissue that may have moved over them.
std::vector<Vec3> carried_edge(const BladeStroke& stroke, std::span<const Vec3> edge,
                               const TetComplex& complex, std::span<const Vec3> positions);

/// New positions of the stroke's line when the blade's edge moves to `edge`. Points that would move less than
/// `least_motion`, m, stay where they are, since the direction of such a small motion is noise.
struct MovedEdge {
  std::vector<Vec3> to;
  std::vector<std::uint8_t> stays;  // by point: 1 if the point stays
};
MovedEdge moved_edge(const BladeStroke& stroke, std::span<const Vec3> from, std::span<const Vec3> edge,
                     double least_motion);

/// Stores the stroke's moved line: parts in tissue by tetrahedron and barycentric weights, so that they move
/// with the tissue, and other parts in the world frame. The line is always stored in the world frame for a
/// sheet, which has no inside. `tree`: tree of tetrahedra; it may lack the last splits. `positions`: m, by
/// node id.
void hold_edge(BladeStroke& stroke, const MovedEdge& moved, const TetComplex& complex, const TetTree& tree,
               std::span<const Vec3> positions);

/// Validates a blade's edge. Throws InputError for fewer than two points and for numbers that are not finite.
void check_edge(std::span<const Vec3> edge);

}  // namespace prosector::cutting
