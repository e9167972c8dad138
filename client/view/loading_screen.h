#pragma once
// The view that a window shows while the scene is loading.

#include <string>

#include "client/view/draw_list.h"

namespace prosector {

/// Returns a view with a progress bar filled to the fraction `progress`, 0 … 1, for the time while a scene is
/// loading. `title` is above the bar, `waits_for` (the current step) below it. Sizes are in pixels; `scale`
/// is DrawList::scale.
DrawList loading_picture(const std::string& title, const std::string& waits_for, double progress, int width,
                         int height, double scale);

}  // namespace prosector
