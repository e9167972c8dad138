#pragma once
// A DrawList's texts, drawn with a pen: dark strokes under bright ones, legible on any ground, over the
// finished picture. Private to client/render.

#include "client/render/screen_quad_drawer.h"
#include "client/view/draw_list.h"

namespace prosector {

void draw_texts(const DrawList& list, const DrawCamera& camera, const ScreenQuadDrawer& drawer);

}  // namespace prosector
