#pragma once
// Where a panel comes up.

#include "common/math.h"

namespace prosector {

struct PanelSite {
  Vec3 touched;  // m, world frame: where the part was touched
  Vec3 lo, hi;   // m, the part's box
  Vec3 reader;   // m, the eyes
  double side;   // ±1: to which side of the part, as the reader sees it; +1 is right
};

/// Returns a place above the part and a little to the side, where reader and fingers find it, facing the
/// reader. Of a reader who looks from above, it is a place beyond the part. Finite and upright for any finite
/// site.
Pose place_panel(const PanelSite& site);
/// Returns how a panel with its middle there is turned so that it faces the reader's eyes; m, world frame.
/// Upright, whatever the places.
Quat face_reader(const Vec3& middle, const Vec3& reader);
/// Tells whether a place (panel's frame, m) is at the board's head, where a hand takes hold of it.
bool is_at_head(const Vec3& at);

}  // namespace prosector
