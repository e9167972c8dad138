#pragma once
// The table and the phantoms in a camera image, in a draw list.

#include <cstdint>
#include <memory>

#include "client/replica/replica.h"
#include "client/view/draw_list.h"
#include "client/view/drawn_bodies.h"
#include "client/view/see_through.h"

namespace prosector {

/// Real objects in a camera image. They are not drawn but occlude bodies and receive shadows.
class RealObjects {
 public:
  /// Replaces the scene's table, which is the fixed body below the board, by the real table in the camera
  /// image. Lights all bodies like it. Lets phantoms occlude. Takes the ids of new meshes from
  /// `next_mesh_id`.
  void add(DrawList& list, const DrawnBodies& bodies, const Replica& replica, const CameraOverlay& through,
           std::uint64_t& next_mesh_id);

 private:
  std::shared_ptr<const DrawMesh> table_;    // null: not seen by a camera yet
  std::shared_ptr<const DrawMesh> phantom_;  // phantom with a custom shape; null: not seen yet

  void add_table(DrawList& list, const Pose& board, std::uint64_t& next_mesh_id);
  void add_phantom(DrawList& list, const FoundPhantom& found, std::uint64_t& next_mesh_id);
};

}  // namespace prosector
