#pragma once
// Words for who wears a headset: what lies over the pictures themselves would be at another angle in each
// eye.

#include <string>

#include "client/view/draw_list.h"

namespace prosector {

/// Adds words in the room, a metre ahead of the list's two eyes and somewhat lower; empty: nothing.
void add_words_ahead(DrawList& list, const std::string& words);

}  // namespace prosector
