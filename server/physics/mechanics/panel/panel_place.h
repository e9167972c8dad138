#pragma once
// Initial pose of a panel.

#include "common/math.h"

namespace prosector {

/// The eyes that a panel faces; world frame.
struct PanelReader {
  Vec3 eyes = Vec3::Zero();   // m
  Vec3 ahead = Vec3::Zero();  // unit, horizontal: direction that the face points to, at any pitch; 0: unknown
};

/// Inputs of a panel's initial pose.
struct PanelSite {
  Vec3 touched;  // m, world frame: the touched point of the part
  Vec3 lo, hi;   // m, bounding box of the part
  PanelReader reader;
  double side;  // ±1: side of the part on which the panel appears, from the reader's view; +1 is right
};

/// Returns a pose above the part and slightly to the side, facing the reader, where eyes and fingers reach
/// it. If the reader looks from above, the panel is placed beyond the part. The pose is finite and upright
/// for any finite site.
Pose place_panel(const PanelSite& site);
/// Returns the rotation of a panel with its centre at `middle` (m, world frame) that faces the reader's eyes.
/// Upright for all positions. For a panel below the eyes, the upper rim is on the side that the reader faces.
Quat face_reader(const Vec3& middle, const PanelReader& reader);
/// Returns whether a position (panel's frame, m) is at the board's head, where hands grasp it.
bool is_at_head(const Vec3& at);

}  // namespace prosector
