#pragma once
// Ancestors of tetrahedra in the mesh before a cut, and the data inherited from them.

#include <optional>
#include <span>

#include "common/assert.h"
#include "server/physics/mechanics/organs/node_transfer.h"

namespace prosector::organs {

/// Tetrahedron of a mesh before a cut: the index of its piece, and its index in the piece's mesh.
struct OldTet {
  std::uint32_t piece = 0;
  std::size_t tet = 0;  // index in the piece
};

/// Returns the tetrahedron before the cut that is `tet` (an id) or the nearest ancestor from which `tet` was
/// split. `before`: the organ's pieces before the change. Returns none if there is no such tetrahedron, as
/// after an undo, which restores the unsplit tetrahedra.
std::optional<OldTet> find_old(const cutting::TetComplex& complex, std::span<const PieceMesh* const> before,
                               cutting::TetId tet);

/// Returns the number of viscoelastic history values per tetrahedron: the size of `history` divided by the
/// number of tetrahedra. Each tetrahedron of `mesh` must be an element of the body.
inline Eigen::Index history_per_tet(const VecX& history, const PieceMesh& mesh) {
  PROSECTOR_ASSERT(!mesh.tets.empty());
  return history.size() / static_cast<Eigen::Index>(mesh.tets.size());
}

/// Returns the viscoelastic history (internal variables of stress relaxation) of the tetrahedra `tets` (ids)
/// after a cut, `numbers` values each. A tetrahedron inherits the values of its ancestor before the cut, or
/// zeros without one. `histories`: values for each piece in `before`, by tetrahedron.
VecX carried_history(const cutting::TetComplex& complex, std::span<const PieceMesh* const> before,
                     std::span<const VecX* const> histories, Eigen::Index numbers,
                     std::span<const cutting::TetId> tets);

}  // namespace prosector::organs
