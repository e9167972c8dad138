#pragma once
// Where a user's eyes are before the screen, in words that a ruler can check, and as a picture.

#include <optional>
#include <string>

#include "client/setup/interface.h"
#include "common/math.h"

namespace prosector {

/// What is measured of a screen and the camera at it, m. The frame is the screen's: from the picture's middle
/// x right, y up, z to the user.
struct ScreenPlace {
  double height = 0;  // of the picture
  Vec3 camera = Vec3::Zero();
};

/// Returns how far the eyes are from the camera and from the picture's middle.
std::string distance_words(const Catalogue& words, const Vec3& eyes, const ScreenPlace& screen);
/// Returns where they are from the picture's middle: aside, up or down, before it, and by which angles.
std::string direction_words(const Catalogue& words, const Vec3& eyes);
/// Draws the screen, its camera and the eyes, where they are known, from above and from the side.
void draw_eyes_before(Interface& ui, const std::optional<Vec3>& eyes, const ScreenPlace& screen);

}  // namespace prosector
