#pragma once
// Contact manifold of two simple shapes: all points at which they touch. proximity() returns the deepest
// point only.

#include <vector>

#include "server/physics/mechanics/collision/narrow/collision_piece.h"

namespace prosector::contact {

/// Point at which two shapes a and b touch or nearly touch, with normal and gap.
struct ShapeTouch {
  Vec3 point = Vec3::Zero();    // m
  Vec3 normal = Vec3::UnitY();  // unit, from b to a
  double gap = 0;               // m, < 0: depth
};

/// Appends the contact points of two shapes whose gap is at most `margin` (m), in a fixed order. If one is a
/// sphere, this is the deepest point only. For two boxes, these are the corners of the clipped contact face.
/// For a mesh b, these are the mesh's vertices and the other shape's corners. For other pairs, these are the
/// deepest point and the support points of both shapes in eight directions, tilted from its normal.
void find_touches(const collision::CollisionPiece& a, const collision::CollisionPiece& b, double margin,
                  std::vector<ShapeTouch>& out);

}  // namespace prosector::contact
