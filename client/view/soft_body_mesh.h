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

  /// Takes `tube_diameter` as in soft_mesh().
  SoftBodyMesh(const SoftReplica& soft, double tube_diameter, std::uint64_t first_id);

  /// Updates the meshes to the replica's current surface; `moved`: it moved since the last call.
  void follow(const SoftReplica& soft, bool moved);

  std::shared_ptr<const DrawMesh> outer() const { return outer_; }
  /// Returns the mesh of the surface exposed by cuts; null: no cuts.
  std::shared_ptr<const DrawMesh> inner() const { return inner_->triangles.empty() ? nullptr : inner_; }

 private:
  double tube_diameter_;
  std::uint64_t shape_;
  std::shared_ptr<DrawMesh> outer_, inner_ = std::make_shared<DrawMesh>();
  std::vector<std::uint32_t> inner_vertices_;  // by vertex of inner_: its vertex in the surface

  void reshape(const SoftReplica& soft);
};

/// Returns the inside's appearance for that of the outside: darker, wetter, without skin.
Appearance inner_appearance(const Appearance& outer);

}  // namespace prosector
