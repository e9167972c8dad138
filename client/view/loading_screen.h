#pragma once
// The view that a window shows while the scene is loading.

#include <string>

#include "client/view/draw_list.h"

namespace prosector {

/// Makes a view of a progress bar filled to the fraction `progress`, 0 … 1. `title` is above the bar,
/// `waits_for` (the current step) below it. Sizes are in pixels; `scale` is DrawList::scale.
DrawList loading_picture(const std::string& title, const std::string& waits_for, double progress, int width,
                         int height, double scale);

}  // namespace prosector
