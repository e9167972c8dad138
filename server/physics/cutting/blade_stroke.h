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
  /// A point of the blade's edge: in the room, and in the tissue where it was in some.
  struct EdgePoint {
    Vec3 room = Vec3::Zero();        // m
    TetId tet = TetComplex::none;    // that it was in
    std::array<double, 4> weight{};  // of its corners
  };
  /// A node that counts as lying on the surface swept, and that surface's plane there, at rest.
  struct Mark {
    NodeId node = 0;
    Vec3 point = Vec3::Zero();   // m
    Vec3 normal = Vec3::Zero();  // unit
  };
  std::vector<EdgePoint> edge;
  std::vector<Mark> marks;  // ascending by node
};

/// `edge`: the blade's, a polyline of at least two points in the room, metres. Throws InputError.
BladeStroke begin_stroke(std::span<const Vec3> edge);

/// Where the edge would be now had it moved along with the tissue it was in.
std::vector<Vec3> carried_edge(const BladeStroke& stroke, const TetComplex& complex,
                               std::span<const Vec3> positions);

/// Remembers the edge, in the tissue; beside a sheet, which has no inside, in the room. `tree` may date from
/// before the last splits.
void hold_edge(BladeStroke& stroke, std::span<const Vec3> edge, const TetComplex& complex,
               const TetTree& tree, std::span<const Vec3> positions);

/// Throws InputError for fewer than two points and numbers that aren't finite.
void check_edge(std::span<const Vec3> edge);

}  // namespace prosector
