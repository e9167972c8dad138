#pragma once
// Caps that close a solid's surface where a section plane cuts it.

#include <cstdint>
#include <vector>

#include "client/view/draw_list.h"

namespace prosector {

/// Point of the curve in which a section plane cuts a solid's surface: its position in the plane, m, and its
/// rest position in the solid, m.
struct OutlinePoint {
  Eigen::Vector2d at;
  Eigen::Vector3f rest;
};

/// Segment of the curve in which a section plane cuts a solid's surface. The solid is on its left, seen from
/// the side that the section's normal points to.
struct OutlineEdge {
  OutlinePoint from, to;
};

/// Returns the pose in the room of a section plane's frame: x and y lie in the plane, z is its normal.
Pose frame_of(const SectionPlane& section);

/// Adds the segments in which the section plane cuts the item's surface to `outline`, in the plane's frame
/// `frame_of(section)`.
void add_outline(const DrawItem& item, const SectionPlane& section, std::vector<OutlineEdge>& outline);

/// Triangles that fill a solid's outline in a section plane, facing +z in the plane's frame.
struct Cap {
  std::vector<OutlinePoint> corners;
  Triangles triangles;
  double area = 0;  // m², of the filled region
};

/// Fills the region that the outline's closed curves enclose: all points with a winding number above 0. Where
/// a curve has a gap, a strip of the gap's height stays open.
Cap fill(const std::vector<OutlineEdge>& outline);

}  // namespace prosector
