#pragma once
// Position of the user's eyes before the screen, as text that a ruler can check, and as a drawing.

#include <optional>
#include <string>

#include "client/setup/interface.h"
#include "common/math.h"

namespace prosector {

/// Measured geometry of a screen and its camera, m. The frame's origin is the centre of the displayed view, x
/// points right, y up, and z towards the user.
struct ScreenGeometry {
  double height = 0;  // of the view
  Vec3 camera = Vec3::Zero();
};

/// Returns a text for the user with the distances of the eyes from the camera and from the centre of the
/// displayed view, in mm. `eyes`: position of their midpoint, m, in the frame of ScreenGeometry.
std::string distance_text(const Catalogue& words, const Vec3& eyes, const ScreenGeometry& screen);
/// Returns a text for the user with the position of the eyes relative to the view's centre: sideways,
/// vertically and in front, in mm, and the sideways and vertical angles. `eyes`: midpoint, m, x right, y up,
/// z towards the user.
std::string direction_text(const Catalogue& words, const Vec3& eyes);
/// Draws the screen, its camera and the midpoint of the eyes, from above and from the right. `eyes`: nullopt
/// if they are not detected.
void draw_eye_position(Interface& ui, const std::optional<Vec3>& eyes, const ScreenGeometry& screen);

}  // namespace prosector
