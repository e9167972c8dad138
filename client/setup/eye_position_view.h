#pragma once
// Position of the user's eyes before the screen, as text that a ruler can check, and as a drawing.

#include <optional>
#include <string>

#include "client/setup/interface.h"
#include "common/math.h"

namespace prosector {

/// Measured geometry of a screen and its camera, m. The screen's frame: origin at the view's centre, x right,
/// y up, z towards the user.
struct ScreenGeometry {
  double height = 0;  // of the view
  Vec3 camera = Vec3::Zero();
};

/// Returns a text with the eyes' distances from the camera and from the view's centre.
std::string distance_text(const Catalogue& words, const Vec3& eyes, const ScreenGeometry& screen);
/// Returns a text with the eyes' position relative to the view's centre: sideways, vertically, in front, and
/// the angles.
std::string direction_text(const Catalogue& words, const Vec3& eyes);
/// Draws the screen, its camera and the eyes, if known, from above and from the side.
void draw_eye_position(Interface& ui, const std::optional<Vec3>& eyes, const ScreenGeometry& screen);

}  // namespace prosector
