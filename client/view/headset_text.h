#pragma once
// Text for headset users, placed in the room. An overlay would be at a different angle in each eye. Also the
// size of texts there.

#include <string>

#include "client/view/draw_list.h"

namespace prosector {

/// Returns the pixels per point (unit of text sizes) for an eye of a headset, at least 1. It is proportional
/// to the resolution, so that texts have the same angular size at any resolution.
double headset_pixels_per_point(const DrawCamera& eye);

/// Adds a text that is placed in the room, a metre ahead of the list's two eyes and somewhat below them. Does
/// nothing if `words` is empty.
void add_headset_text(DrawList& list, const std::string& words);

}  // namespace prosector
