#pragma once
// Repair of common faults of tetrahedral mesh files.

#include <cstddef>
#include <string>

#include "common/anatomy/progress.h"
#include "common/mesh.h"

namespace prosector {

/// Drops flat and duplicate tetrahedra, flips inverted ones, and merges coincident nodes if that connects
/// pieces; reports each repair in one line. Throws InputError, beginning with `name`, if no tetrahedron is
/// left, if more than two tetrahedra share a face, or if two cells split their common face differently.
TetMesh repaired(TetMesh mesh, const std::string& name, const Progress& report);

/// Overlap of tetrahedra of positive volume.
struct TetOverlap {
  std::size_t tets = 0;  // number of tetrahedra in the smaller of two groups that are folded over each other
  double enclosed = 0;   // m³: inside the boundary, if no pieces cross; without overlap, the total
};
TetOverlap find_tet_overlap(const TetMesh& mesh);

}  // namespace prosector
