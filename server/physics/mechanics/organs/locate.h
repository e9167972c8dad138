#pragma once
// Point location in tetrahedra.

#include <optional>
#include <vector>

#include "common/mesh.h"
#include "server/physics/mechanics/collision/primitives/aabb.h"

namespace prosector {

/// Index of a mesh's tetrahedra near a box. It takes one pass over the mesh, for any number of queries in the
/// box.
class Locator {
 public:
  /// Builds the index for node positions `x` (3n, m; more nodes than the tetrahedra's corners may follow).
  /// Both arguments must outlive this.
  Locator(const TetMesh& mesh, const VecX& x, const Aabb& box);
  /// Returns the corners of the first tetrahedron that contains the point, faces included, with barycentric
  /// weights; none if outside. Inverted tetrahedra contain no points. The point must be in the box.
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
