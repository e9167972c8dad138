#pragma once
// Draws a DrawList's lines: first those with a depth test, then those without. Private to client/render.

#include "client/render/screen_quad_drawer.h"
#include "client/view/draw_list.h"

namespace prosector {

void draw_lines(const DrawList& list, const DrawCamera& camera, const ScreenQuadDrawer& drawer);

}  // namespace prosector
