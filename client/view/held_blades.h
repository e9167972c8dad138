#pragma once
// Hand-held blades: highlighted edges, and predicted cut lines on tissue.

#include <vector>

#include "client/replica/replica.h"
#include "client/view/blade_frame.h"
#include "client/view/draped_line.h"
#include "client/view/draw_list.h"

namespace prosector {

/// Returns whether the body is a blade in a user's hand.
bool is_held_blade(const Replica& replica, BodyId body);

/// Adds the edges as lines that stay faintly visible where occluded. `pose`: of the body.
void add_edges(DrawList& list, const std::vector<CuttingEdge>& edges, const Pose& pose);

/// Returns the predicted line of the next cut on the tissue below or around the blade, if its tip moves on
/// along the edge; empty: no tissue near. `find` must ignore the blade; `blade` is in the world frame.
std::vector<Vec3> next_cut(const Replica& replica, const BladeFrame& blade, const FindSurface& find);

/// Adds the line of a predicted cut on tissue.
void add_guide(DrawList& list, const std::vector<Vec3>& line);

}  // namespace prosector
