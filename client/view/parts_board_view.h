#pragma once
// The list of parts as a board in the room.

#include <memory>

#include "client/view/parts_list.h"

namespace prosector {

/// The list, and the board's pose: its middle, +x to the reader's right, +y up, +z towards the reader; m.
struct PlacedPartsList {
  const PartsList* list;
  Pose pose;
};

inline constexpr double board_metres_per_point = 0.0008;
// The picture (points) that a board's list is laid out in; its middle is the board's.
inline const Eigen::Vector2d parts_board_picture(parts_list_width + 2 * parts_list_gap, 470);

/// Returns where a place before the board (its frame, m) is on the list, in points.
Eigen::Vector2d board_point(const Vec3& place);

/// Adds the board to what is drawn. `cube`: board_cube().
void add_parts_board(DrawList& out, const PlacedPartsList& placed,
                     const std::shared_ptr<const DrawMesh>& cube);

/// Makes the cube, 1 m wide, that plates of boards are made of.
std::shared_ptr<const DrawMesh> board_cube(std::uint64_t mesh_id);

}  // namespace prosector
