#pragma once
// Text for headset users, placed in the room. An overlay would be at a different angle in each eye. Also the
// size of texts there.

#include <string>

#include "client/view/draw_list.h"

namespace prosector {

/// Returns the pixels per point for a headset's eye, at least 1. Texts have the same angular size at any
/// resolution.
double headset_pixels_per_point(const DrawCamera& eye);

/// Adds text in the room, a metre ahead of the list's two eyes and somewhat lower; empty: none.
void add_headset_text(DrawList& list, const std::string& words);

}  // namespace prosector
