#pragma once
// What tells how far a hand is from what lies below it. A line leads down from the fingertips to a ring. A
// shadow there grows darker as they come near.

#include <array>
#include <functional>
#include <memory>
#include <optional>

#include "client/view/draw_list.h"
#include "client/view/pick.h"

namespace prosector {

class HandCues {
 public:
  /// Finds what a ray meets first; of one body alone, if it is given.
  using Find = std::function<std::optional<Picked>(const Ray&, std::optional<BodyId>)>;

  /// Adds the cues of a hand whose fingertips are there (m, world frame); over nothing there are none.
  /// Returns what lies near below them. Meshes get ids from `next_mesh_id` on.
  std::optional<BodyId> add(DrawList& list, const Vec3& fingertips, const Find& find,
                            std::uint64_t& next_mesh_id);

 private:
  static constexpr std::size_t bands = 7;  // of the shadow, from its middle outwards
  std::array<std::shared_ptr<DrawMesh>, bands> shadow_;

  void make_meshes(std::uint64_t& next_mesh_id);
};

}  // namespace prosector
