#pragma once
// What a window shows while the scene is on its way.

#include <string>

#include "client/view/draw_list.h"

namespace prosector {

/// Makes a picture of a bar that is full to the share `progress`, 0 … 1, with what is waited for below it.
/// `title` stands above. Sizes are in pixels, `scale` is DrawList's.
DrawList loading_picture(const std::string& title, const std::string& waits_for, double progress, int width,
                         int height, double scale);

}  // namespace prosector
