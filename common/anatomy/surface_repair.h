#pragma once
// What surface files often get wrong, put right where that is safe.

#include <string>
#include <vector>

#include "common/mesh.h"

namespace prosector {

struct RepairedSurface {
  TriangleMesh surface;
  std::vector<std::string> notes;  // one line each: what was changed, or should be
};

/// Repairs a surface where it isn't closed. Merges vertices that rounding parted, drops triangles that are
/// there twice, and turns triangles so that neighbours face alike. A surface without such faults is returned
/// as it is. What can't be repaired stays: see surface_faults().
RepairedSurface repaired(TriangleMesh surface);

/// A closed surface whose shells face away from the solids that they bound.
struct SolidShells {
  TriangleMesh surface;
  std::vector<std::string> notes;  // as of RepairedSurface
  std::vector<double> solids;      // volumes of separate solids without their cavities, the largest first
  bool simple = false;             // one shell, a manifold: distances alone tell inside from outside
  bool overlapping = false;        // some shells lie neither apart nor within each other, by their boxes
};

/// Sorts the shells of a closed surface, which are joined through edges. One that faces inward and lies
/// within a solid is a cavity, others are turned outward. One that faces outward and lies within a solid
/// bounds nothing and is dropped. Shells that cross each other both stay.
SolidShells solid_shells(const TriangleMesh& closed);

}  // namespace prosector
