#pragma once
// Blades in people's hands: bright edges, and lines on tissue where they would cut.

#include <vector>

#include "client/replica/replica.h"
#include "client/view/blade_frame.h"
#include "client/view/draped_line.h"
#include "client/view/draw_list.h"

namespace prosector {

/// Tells whether the body is a blade in somebody's hand.
bool is_held_blade(const Replica& replica, BodyId body);

/// Adds the edges, which shine through what hides them. `pose`: of the body.
void add_edges(DrawList& list, const std::vector<CuttingEdge>& edges, const Pose& pose);

/// Returns the line on the tissue that a blade over it or in it would cut next, when its tip goes on along
/// the edge; empty: there is none near. `find` leaves the blade out, `blade` is in the world frame.
std::vector<Vec3> next_cut(const Replica& replica, const BladeFrame& blade, const FindSurface& find);

/// Adds a line on tissue where a blade would cut.
void add_guide(DrawList& list, const std::vector<Vec3>& line);

}  // namespace prosector
