#pragma once
// The force that a hand would feel, drawn for who has no arm to feel it with.

#include "client/view/draw_list.h"

namespace prosector {

/// Adds an arrow from where the hand touches (m, world frame) along the force on it, N. It is as long as the
/// force is large, up to a length that still fits the picture; a force that hardly is gets none.
void add_force_arrow(DrawList& list, const Vec3& point, const Vec3& force);

}  // namespace prosector
