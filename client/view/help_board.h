#pragma once
// The help text as a separate board over the view.

#include <string>

#include "client/view/draw_list.h"

namespace prosector {

/// Adds the help text (client/app/terminal/controls.h, columns separated by tabs) on a board over the view,
/// as two blocks side by side. The second block begins at a device's heading if one is near the middle. Both
/// blocks shrink until they fit into the view.
void add_help(DrawList& list, const std::string& help);

}  // namespace prosector
