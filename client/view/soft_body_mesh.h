#pragma once
// Render meshes of a deformable body: its original surface and the surface exposed by cuts. The two share no
// vertices, so there is a crease where they meet.

#include <cstdint>
#include <memory>
#include <vector>

#include "client/replica/soft_replica.h"
#include "client/view/draw_list.h"

namespace prosector {

class SoftBodyMesh {
 public:
  static constexpr std::uint64_t meshes = 2;  // mesh ids per object

  /// Creates the render meshes of a soft body, with successive ids from `first_id`. `tube_diameter`, m, is
  /// that of a rope, which is drawn as a tube; 0: not a rope.
  SoftBodyMesh(const SoftReplica& soft, double tube_diameter, std::uint64_t first_id);

  /// Updates the render meshes to the replica's current surface. `moved`: whether the surface moved since the
  /// last call.
  void follow(const SoftReplica& soft, bool moved);

  std::shared_ptr<const DrawMesh> outer() const { return outer_; }
  /// Returns the render mesh of the surface that cuts have exposed; null if there are no cuts.
  std::shared_ptr<const DrawMesh> inner() const { return inner_->triangles.empty() ? nullptr : inner_; }

 private:
  double tube_diameter_;
  std::uint64_t shape_;
  std::shared_ptr<DrawMesh> outer_, inner_ = std::make_shared<DrawMesh>();
  std::vector<std::uint32_t> inner_vertices_;  // by vertex of inner_: its vertex in the surface

  void reshape(const SoftReplica& soft);
};

/// Returns the appearance of a body's inside, which cuts expose, from that of its outside: darker, wetter,
/// without skin.
Appearance inner_appearance(const Appearance& outer);

}  // namespace prosector
