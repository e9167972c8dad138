#pragma once
// Contact gap and normal of a tissue vertex near a rigid collider.
//
// The shortest way out of the collider is the wrong one in two cases. Tissue that is pressed in by more than
// half the collider's thickness would be pushed through it. And when an edge slides over a vertex by a small
// amount, the edge's side face would stop there, although the tissue below yields. A vertex that pressed in
// the last tick leaves the collider along the normal of that contact. A vertex that is met for the first time
// moves back into its own tissue, against the surface normal.

#include "server/physics/mechanics/contact/surface_detector.h"

namespace prosector::contact {

/// Position, normals and last contact of a tissue vertex that is close to a rigid collider.
struct Approach {
  Vec3 at = Vec3::Zero();        // m, world frame
  Distance nearest;              // to the collider, from there
  const Vec3* before = nullptr;  // unit: normal of the last tick's contact if it pressed; null: none
  double depth = 0;              // m: depth of that contact at the end of its tick
  Vec3 outward = Vec3::Zero();   // unit, out of the tissue; zero: the tissue has no inside
  double lip = 0;                // m: vertices that an edge overlaps by less than this are treated as grazed
};

/// Returns gap and normal of the contact between a tissue vertex and a collider, on the side from which the
/// vertex came. Returns none if the collider's edge only grazes the vertex.
std::optional<Distance> side_of(const Collider& collider, const Approach& vertex);

}  // namespace prosector::contact
