#pragma once
// A deformable to draw: the surface that it was given, and what cuts laid bare of its inside. The two share
// no vertices, so there is a crease where they meet.

#include <cstdint>
#include <memory>
#include <vector>

#include "client/replica/soft_replica.h"
#include "client/view/draw_list.h"

namespace prosector {

class SoftBodyMesh {
 public:
  static constexpr std::uint64_t meshes = 2;  // ids that each needs

  /// Takes `tube_diameter` as soft_mesh() does.
  SoftBodyMesh(const SoftReplica& soft, double tube_diameter, std::uint64_t first_id);

  /// Brings the meshes to the replica's surface as it is now; `moved`: it did since the last call.
  void follow(const SoftReplica& soft, bool moved);

  std::shared_ptr<const DrawMesh> outer() const { return outer_; }
  /// Returns the mesh of what cuts laid bare; null while nothing was.
  std::shared_ptr<const DrawMesh> inner() const { return inner_->triangles.empty() ? nullptr : inner_; }

 private:
  double tube_diameter_;
  std::uint64_t shape_;
  std::shared_ptr<DrawMesh> outer_, inner_ = std::make_shared<DrawMesh>();
  std::vector<std::uint32_t> inner_vertices_;  // of the surface, behind each of inner_

  void reshape(const SoftReplica& soft);
};

/// Returns the inside's appearance by that of the outside: darker, wetter, without skin.
Appearance inner_appearance(const Appearance& outer);

}  // namespace prosector
