#pragma once
// Where a panel comes up.

#include "common/math.h"

namespace prosector {

/// The eyes that a panel faces; world frame.
struct PanelReader {
  Vec3 eyes = Vec3::Zero();   // m
  Vec3 ahead = Vec3::Zero();  // level unit vector: which way they face, however steeply they look; 0: unknown
};

struct PanelSite {
  Vec3 touched;  // m, world frame: where the part was touched
  Vec3 lo, hi;   // m, the part's box
  PanelReader reader;
  double side;  // ±1: to which side of the part, as the reader sees it; +1 is right
};

/// Returns a place above the part and a little to the side, where reader and fingers find it, facing the
/// reader. Of a reader who looks from above, it is a place beyond the part. Finite and upright for any finite
/// site.
Pose place_panel(const PanelSite& site);
/// Returns how a panel with its middle there is turned so that it faces the reader's eyes; m, world frame.
/// Upright, whatever the places; below the eyes its upper rim is on the side that the reader faces.
Quat face_reader(const Vec3& middle, const PanelReader& reader);
/// Tells whether a place (panel's frame, m) is at the board's head, where a hand takes hold of it.
bool is_at_head(const Vec3& at);

}  // namespace prosector
