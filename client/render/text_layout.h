#pragma once
// Where texts stand in a picture. Those at places in the room (names, figures) stand above their places;
// where two would cover each other, the later one is lifted over the earlier. No GL.

#include <vector>

#include "client/text/typesetter.h"
#include "client/view/draw_list.h"

namespace prosector {

struct PlacedText {
  const DrawText* text;
  SetText set;
  Eigen::Vector2d origin;  // top left of the first line, pixels from the viewport's top left
  Eigen::Vector2d size;    // pixels
  double lift = 0;         // pixels that it stands above its place
};

/// Places all texts but those on surfaces that this camera sees, in their order; the list and its cameras
/// outlive the result. All eyes lift alike, as the list's first camera asks for: nobody can fuse pictures
/// whose texts differ in height.
std::vector<PlacedText> place_texts(const DrawList& list, const DrawCamera& camera, Typesetter& typesetter);

}  // namespace prosector
