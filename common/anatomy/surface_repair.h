#pragma once
// Repair of common faults of surface files.

#include <string>
#include <vector>

#include "common/mesh.h"

namespace prosector {

struct RepairedSurface {
  TriangleMesh surface;
  std::vector<std::string> notes;  // one line each: repairs made, and recommendations
};

/// Returns the surface after repairing common faults that keep it from being closed. Merges vertices
/// separated by rounding, removes duplicate triangles, and flips triangles so that neighbours are
/// consistently oriented. A surface without such faults is returned unchanged. Faults that can't be repaired
/// remain: see surface_faults().
RepairedSurface repaired(TriangleMesh surface);

/// A closed surface whose shells (connected pieces) face outward from the solids that they bound, with the
/// solids' volumes and notes for users.
struct SolidShells {
  TriangleMesh surface;
  std::vector<std::string> notes;  // as in RepairedSurface
  std::vector<double> solids;      // volumes of separate solids without their cavities, largest first
  bool simple = false;             // one manifold shell: Sign::nearest suffices
  bool overlapping = false;        // some shells overlap, judged by their boxes
};

/// Classifies the edge-connected shells of a closed surface, and returns them facing outward from the solids
/// that they bound. A shell inside a solid is a cavity if it faces inward; if it faces outward, it bounds
/// nothing and is removed. All other shells are flipped outward if necessary. Shells that cross each other
/// are both kept.
SolidShells solid_shells(const TriangleMesh& closed);

}  // namespace prosector
