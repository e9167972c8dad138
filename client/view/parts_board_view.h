#pragma once
// The list of parts as a board in the room.

#include <memory>

#include "client/view/parts_list.h"

namespace prosector {

/// List of parts and the pose of the board in the room that shows it. The pose's frame, m, has its origin at
/// the board's centre, +x to the reader's right, +y up, and +z towards the reader.
struct PlacedPartsList {
  const PartsList* list;
  Pose pose;
};

inline constexpr double board_metres_per_point = 0.0008;
// Size (points) of the area that a board's list is laid out in. Its centre is the board's centre.
inline const Eigen::Vector2d parts_board_picture(parts_list_width + 2 * parts_list_gap, 470);

/// Converts a position in the frame of the board with the list of parts (m) to points of the list's layout.
Eigen::Vector2d board_point(const Vec3& place);

/// View of the list of parts on a board in the room: one mesh with vertex colours for all its rectangles,
/// such as the board's background, and texts on it.
class PartsBoardView {
 public:
  static constexpr std::uint64_t meshes = 1;  // ids, from the first one on
  explicit PartsBoardView(std::uint64_t mesh_id) { mesh_->id = mesh_id; }
  void add(DrawList& out, const PlacedPartsList& placed);

 private:
  std::shared_ptr<DrawMesh> mesh_ = std::make_shared<DrawMesh>();
};

}  // namespace prosector
