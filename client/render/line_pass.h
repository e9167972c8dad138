#pragma once
// A DrawList's lines: those of the room behind what hides them, then those over it. Private to
// client/render.

#include "client/render/screen_quad_drawer.h"
#include "client/view/draw_list.h"

namespace prosector {

void draw_lines(const DrawList& list, const DrawCamera& camera, const ScreenQuadDrawer& drawer);

}  // namespace prosector
