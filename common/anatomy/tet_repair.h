#pragma once
// What files of tetrahedra often get wrong: put right where that is safe, else refused.

#include <cstddef>
#include <string>

#include "common/anatomy/progress.h"
#include "common/mesh.h"

namespace prosector {

/// Drops flat and repeated tetrahedra, turns inverted ones, and merges nodes that stand at one place where
/// pieces then join; reports what was done, one line each. Throws InputError, beginning with `name`, where
/// none is left, where more than two tetrahedra share a face, and where two cells split their common face
/// differently.
TetMesh repaired(TetMesh mesh, const std::string& name, const Progress& report);

/// How tetrahedra of positive volume lie in each other.
struct Tangles {
  std::size_t tets =
      0;  // that lie on the same side of a shared face as their neighbour there: the fewer of them
  double enclosed = 0;  // m³: volume within the border, where no pieces cross; without tangles, that of all
};
Tangles find_tangles(const TetMesh& mesh);

}  // namespace prosector
