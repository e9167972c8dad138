#pragma once
// What fills the hole where a plane opens a solid, made of the solid's surface.

#include <cstdint>
#include <vector>

#include "client/view/draw_list.h"

namespace prosector {

/// A point of the section's outline: where it is in the plane, m, and where it was in the rest shape, m.
struct OutlinePoint {
  Eigen::Vector2d at;
  Eigen::Vector3f rest;
};

/// A piece of the outline, with the solid on its left as seen from where the section's normal points.
struct OutlineEdge {
  OutlinePoint from, to;
};

/// Maps the section's plane to the room: x and y lie in the plane, z is its normal.
Pose frame_of(const SectionPlane& section);

/// Adds where the section meets the item's surface, in the plane of `frame_of(section)`.
void add_outline(const DrawItem& item, const SectionPlane& section, std::vector<OutlineEdge>& outline);

/// Triangles that fill outlines, facing +z in the plane's frame.
struct Cap {
  std::vector<OutlinePoint> corners;
  Triangles triangles;
  double area = 0;  // m², of what is filled
};

/// Fills what lies inside of more outlines than outside. Where an outline has a gap, a strip as high as the
/// gap stays open.
Cap fill(const std::vector<OutlineEdge>& outline);

}  // namespace prosector
