#pragma once
// The help as a board of its own over the picture.

#include <string>

#include "client/view/draw_list.h"

namespace prosector {

/// Adds the help (client/app/controls.h, columns divided by tabs) in two blocks beside each other, from a
/// device's heading on where that halves it well. Both shrink until all of it is in the picture.
void add_help(DrawList& list, const std::string& help);

}  // namespace prosector
