#pragma once
// Depth cues of a hand: a line from the fingertips down to a ring on the surface below, and a shadow there
// that darkens as they approach.

#include <array>
#include <memory>
#include <optional>

#include "client/view/draped_line.h"
#include "client/view/draw_list.h"

namespace prosector {

class HandCues {
 public:
  /// Adds the depth cues of a hand with fingertips at `fingertips` (m, world frame): a line down to a ring on
  /// the surface below, and a shadow there. Adds nothing if there is no surface below. Takes the ids of new
  /// meshes from `next_mesh_id`.
  void add(DrawList& list, const Vec3& fingertips, const FindSurface& find, std::uint64_t& next_mesh_id);

 private:
  static constexpr std::size_t bands = 7;  // of the shadow, from its centre outwards
  std::array<std::shared_ptr<DrawMesh>, bands> shadow_;

  void make_meshes(std::uint64_t& next_mesh_id);
};

}  // namespace prosector
