#pragma once
// What a cut changed in a mesh of tetrahedra whose nodes and tetrahedra else keep their indices: so that what
// hangs on the mesh can follow instead of being made anew.

#include <array>
#include <cstdint>
#include <vector>

#include "common/mesh.h"

namespace prosector {

struct MeshEdit {
  using Corners = std::array<std::uint32_t, 4>;

  std::vector<Vec3> positions;          // m, at rest: of the nodes that follow those that were there
  std::vector<std::uint32_t> tets;      // whose corners changed, then all new ones; ascending
  std::vector<Corners> corners;         // what they are now
  std::vector<Corners> corners_before;  // of those that were there
  std::vector<std::uint32_t> nodes;     // the corners of these, before and now; ascending

  /// How many tetrahedra are new.
  std::size_t new_tets() const { return tets.size() - corners_before.size(); }
};

inline void apply(const MeshEdit& edit, TetMesh& mesh) {
  mesh.positions.insert(mesh.positions.end(), edit.positions.begin(), edit.positions.end());
  mesh.tets.resize(mesh.tets.size() + edit.new_tets());
  for (std::size_t i = 0; i < edit.tets.size(); ++i) mesh.tets[edit.tets[i]] = edit.corners[i];
}

inline void take_back(const MeshEdit& edit, TetMesh& mesh) {
  mesh.positions.resize(mesh.positions.size() - edit.positions.size());
  mesh.tets.resize(mesh.tets.size() - edit.new_tets());
  for (std::size_t i = 0; i < edit.corners_before.size(); ++i)
    mesh.tets[edit.tets[i]] = edit.corners_before[i];
}

}  // namespace prosector
