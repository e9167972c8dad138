#pragma once
// Initial pose of a panel.

#include "common/math.h"

namespace prosector::panel {

/// Eyes of the participant that a panel faces; position and direction in the world frame.
struct PanelReader {
  Vec3 eyes = Vec3::Zero();   // m
  Vec3 ahead = Vec3::Zero();  // unit, horizontal: direction that the face points to, at any pitch; 0: unknown
};

/// Data from which place_panel() computes the initial pose of a panel: the touched part, and the
/// participant's eyes.
struct PanelSite {
  Vec3 touched;  // m, world frame: the touched point of the part
  Vec3 lo, hi;   // m, bounding box of the part
  PanelReader reader;
  double side;  // ±1: side of the part on which the panel appears, from the reader's view; +1 is right
};

/// Returns the initial pose, in the world frame, of a panel that a participant opened by touching a part. The
/// panel is above the part and slightly to the side, faces the participant's eyes, and is within reach. If
/// the participant looks at the part from above, the panel is placed behind the part. The pose is finite and
/// upright for any finite input.
Pose place_panel(const PanelSite& site);
/// Returns the rotation that makes a panel with its centre at `middle` (m, world frame) face the reader's
/// eyes. The panel's lower and upper rims are always horizontal. If the panel is far below the eyes, its
/// upper rim points in the direction that the reader faces.
Quat face_reader(const Vec3& middle, const PanelReader& reader);
/// Returns whether a position (m, panel's frame) is at the head of the panel's board, the strip at its upper
/// rim where a fist grasps it.
bool is_at_head(const Vec3& at);

}  // namespace prosector::panel
