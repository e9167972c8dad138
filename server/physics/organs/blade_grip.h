#pragma once
// Where tissue holds back a point of a blade's edge.

#include <optional>
#include <vector>

#include "server/physics/contact/contact.h"
#include "server/physics/state.h"

namespace prosector {

struct BladeGrip {
  std::size_t body = 0;   // soft
  std::size_t slot = 0;   // of the instrument
  std::size_t point = 0;  // of Blade::cut_to
  SparseMap::Row row;     // of the material where the point has cut to
  /// Where the edge goes through a sheet between this point and the next, as a share of the way; none: in a
  /// solid.
  std::optional<double> through{};
  Vec3 beside = Vec3::Zero();  // m: from that material to the point, of one that has come down on a sheet
  Tie tie;
};

/// Returns where the points of a held instrument's edges are, m, world frame.
std::vector<Vec3> edge_points(const Bodies& bodies, std::size_t slot);

/// Takes up the blades that hands hold now, and lists which of their points tissue holds back; wakes it.
void grip_blades(State& state, std::vector<BladeGrip>& grips);

}  // namespace prosector
