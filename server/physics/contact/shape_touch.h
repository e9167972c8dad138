#pragma once
// All the points at which two simple shapes bear each other, where proximity() tells the deepest.

#include <vector>

#include "server/physics/collision/narrow/collision_piece.h"

namespace prosector {

struct ShapeTouch {
  Vec3 point = Vec3::Zero();    // m
  Vec3 normal = Vec3::UnitY();  // unit, from b to a
  double gap = 0;               // m, < 0: depth
};

/// Appends the touches whose gap is at most `margin` (m), in a fixed order:
///   of spheres the one
///   of two boxes the corners of the clipped face
///   of a mesh its vertices and the other's corners
///   of others the deepest, and the farthest points of both in eight directions that lean away from its
///   normal
void find_touches(const CollisionPiece& a, const CollisionPiece& b, double margin,
                  std::vector<ShapeTouch>& out);

}  // namespace prosector
