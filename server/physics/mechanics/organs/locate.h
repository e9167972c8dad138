#pragma once
// Point location in tetrahedra.

#include <optional>
#include <vector>

#include "common/mesh.h"
#include "server/physics/mechanics/collision/primitives/aabb.h"

namespace prosector::organs {

/// Spatial index of the tetrahedra of a mesh that are near a box, for finding the tetrahedron that contains a
/// point of that box. Building it takes one pass over the mesh.
class Locator {
 public:
  /// Collects the tetrahedra whose bounding boxes overlap `box`. `x`: node positions (3 per node, m); it may
  /// hold more nodes than the tetrahedra use. Stores pointers to `mesh` and `x`, which must outlive this
  /// object.
  Locator(const TetMesh& mesh, const VecX& x, const collision::Aabb& box);
  /// Returns the first tetrahedron of the indexed mesh that contains `point` (m), as its four corner nodes
  /// with barycentric weights. Points on faces count as inside. Returns none if no tetrahedron contains it.
  /// Inverted tetrahedra contain no points. `point` must lie in the box for which the index was built.
  std::optional<SparseMap::Row> at(const Vec3& point) const;

 private:
  struct Near {
    collision::Aabb box;
    std::uint32_t tet;
  };
  const TetMesh* mesh_;
  const VecX* x_;
  std::vector<Near> near_;  // ascending
};

}  // namespace prosector::organs
