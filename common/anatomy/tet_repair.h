#pragma once
// Repair of common faults of tetrahedral mesh files.

#include <cstddef>
#include <string>

#include "common/anatomy/progress.h"
#include "common/mesh.h"

namespace prosector {

/// Returns the tetrahedral mesh with common faults repaired, and reports each repair in one line. Removes
/// flat and duplicate tetrahedra, flips inverted ones, and merges coincident nodes if that connects pieces.
/// Throws InputError, beginning with `name`, if no tetrahedron is left, if more than two tetrahedra share a
/// face, or if two hexahedra divided into tetrahedra split their common face differently.
TetMesh repaired(TetMesh mesh, const std::string& name, const Progress& report);

/// Result of testing whether tetrahedra of a mesh overlap: the number of tetrahedra that are folded over
/// others, and the enclosed volume.
struct TetOverlap {
  std::size_t tets = 0;  // number of tetrahedra in the smaller of two groups that are folded over each other
  double enclosed = 0;   // m³: inside the boundary, if no pieces cross; without overlap, the total
};
TetOverlap find_tet_overlap(const TetMesh& mesh);

}  // namespace prosector
