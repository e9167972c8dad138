#pragma once
// Positions of texts in a view. Texts at points of the room (names, statistics) are above their points. If
// two overlap, the later one is lifted over the earlier one. No GL.

#include <vector>

#include "client/text/typesetter.h"
#include "client/view/draw_list.h"

namespace prosector {

struct PlacedText {
  const DrawText* text;
  SetText set;
  Eigen::Vector2d origin;  // top left of the first line, pixels from the viewport's top left
  Eigen::Vector2d size;    // pixels
  double lift = 0;         // pixels that it is lifted above its point
};

/// Returns the positions of all texts that this camera sees, except those written on surfaces, in the list's
/// order. The list and its cameras must outlive the result. All eyes lift overlapping texts as far as the
/// list's first camera does, because texts at different heights cannot be fused stereoscopically.
std::vector<PlacedText> place_texts(const DrawList& list, const DrawCamera& camera, Typesetter& typesetter);

}  // namespace prosector
