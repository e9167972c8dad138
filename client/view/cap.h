#pragma once
// Caps that close a solid's surface where a section plane cuts it.

#include <cstdint>
#include <vector>

#include "client/view/draw_list.h"

namespace prosector {

/// A point of the section's outline: its position in the plane, m, and its rest position, m.
struct OutlinePoint {
  Eigen::Vector2d at;
  Eigen::Vector3f rest;
};

/// A segment of the outline. The solid is on its left, seen from the side that the section's normal points
/// to.
struct OutlineEdge {
  OutlinePoint from, to;
};

/// Returns the frame of the section's plane in the room: x and y lie in the plane, z is its normal.
Pose frame_of(const SectionPlane& section);

/// Adds the intersection of the section with the item's surface, in the frame `frame_of(section)`.
void add_outline(const DrawItem& item, const SectionPlane& section, std::vector<OutlineEdge>& outline);

/// Triangles that fill outlines, facing +z in the plane's frame.
struct Cap {
  std::vector<OutlinePoint> corners;
  Triangles triangles;
  double area = 0;  // m², of the filled region
};

/// Fills the region that lies inside more outlines than outside (winding number above 0). Where an outline
/// has a gap, a strip of the gap's height stays open.
Cap fill(const std::vector<OutlineEdge>& outline);

}  // namespace prosector
