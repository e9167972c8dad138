#pragma once
// Words for who wears a headset: what lies over the pictures themselves would be at another angle in each
// eye. And how large texts are there.

#include <string>

#include "client/view/draw_list.h"

namespace prosector {

/// Returns how many pixels a point has in a headset's eye, 1 at least: texts are as large to its wearer
/// whatever the pixels.
double headset_scale(const DrawCamera& eye);

/// Adds words in the room, a metre ahead of the list's two eyes and somewhat lower; empty: nothing.
void add_words_ahead(DrawList& list, const std::string& words);

}  // namespace prosector
