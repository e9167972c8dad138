#pragma once
// Hand-held blades: highlighted edges, and predicted cut lines on tissue.

#include <vector>

#include "client/replica/replica.h"
#include "client/view/blade_frame.h"
#include "client/view/draped_line.h"
#include "client/view/draw_list.h"

namespace prosector {

/// Returns whether the body is rigid with a cutting edge and is held by a user's hand.
bool is_held_blade(const Replica& replica, BodyId body);

/// Adds the cutting edges of a blade as lines, which stay faintly visible where they are occluded. `pose`:
/// room pose of the blade's body.
void add_edges(DrawList& list, const std::vector<CuttingEdge>& edges, const Pose& pose);

/// Returns points (m, world frame) of the line on the tissue along which the blade would cut if it were drawn
/// in the direction that its edge faces. Returns no points if no tissue is near its tip. `find` must ignore
/// the blade's body; `blade` is in the world frame.
std::vector<Vec3> next_cut(const Replica& replica, const BladeFrame& blade, const FindSurface& find);

/// Adds a predicted cut on tissue as a drawn line through the points (m, world frame).
void add_guide(DrawList& list, const std::vector<Vec3>& line);

}  // namespace prosector
