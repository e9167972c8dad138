#pragma once
// Which tetrahedra points of the room are in.

#include <optional>
#include <vector>

#include "common/mesh.h"
#include "server/physics/collision/primitives/aabb.h"

namespace prosector {

/// The tetrahedra of a mesh that are near a box: one pass over the mesh, however many points of the box are
/// asked for.
class Locator {
 public:
  /// Builds the locator for nodes at `x` (3n, m; more of them than the tetrahedra's corners may follow). Both
  /// must outlive this.
  Locator(const TetMesh& mesh, const VecX& x, const Aabb& box);
  /// Returns the corners of the first tetrahedron that contains the point, its faces included, with the
  /// point's barycentric weights; nothing outside. Turned-over tetrahedra contain nothing. The point must be
  /// in the box.
  std::optional<SparseMap::Row> at(const Vec3& point) const;

 private:
  struct Near {
    Aabb box;
    std::uint32_t tet;
  };
  const TetMesh* mesh_;
  const VecX* x_;
  std::vector<Near> near_;  // ascending
};

}  // namespace prosector
