#pragma once
// What tells how far a hand is from what lies below it. A line leads down from the fingertips to a ring. A
// shadow there grows darker as they come near.

#include <array>
#include <memory>
#include <optional>

#include "client/view/draped_line.h"
#include "client/view/draw_list.h"

namespace prosector {

class HandCues {
 public:
  /// Adds the cues of a hand whose fingertips are there (m, world frame); over nothing there are none.
  /// Meshes get ids from `next_mesh_id` on.
  void add(DrawList& list, const Vec3& fingertips, const FindSurface& find, std::uint64_t& next_mesh_id);

 private:
  static constexpr std::size_t bands = 7;  // of the shadow, from its middle outwards
  std::array<std::shared_ptr<DrawMesh>, bands> shadow_;

  void make_meshes(std::uint64_t& next_mesh_id);
};

}  // namespace prosector
