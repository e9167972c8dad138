#pragma once
// Contact manifold of two simple shapes: all points at which they touch. proximity() returns the deepest
// point only.

#include <vector>

#include "server/physics/mechanics/collision/narrow/collision_piece.h"

namespace prosector {

/// A contact point of two shapes.
struct ShapeTouch {
  Vec3 point = Vec3::Zero();    // m
  Vec3 normal = Vec3::UnitY();  // unit, from b to a
  double gap = 0;               // m, < 0: depth
};

/// Appends the contact points whose gap is at most `margin` (m), in a fixed order:
///   with a sphere: the deepest point
///   two boxes: the corners of the clipped face
///   with a mesh: the mesh's vertices and the other shape's corners
///   others: the deepest point, and the support points of both in eight directions tilted from its normal
void find_touches(const CollisionPiece& a, const CollisionPiece& b, double margin,
                  std::vector<ShapeTouch>& out);

}  // namespace prosector
