#pragma once
// Ancestors of tetrahedra in the mesh before a cut, and the data inherited from them.

#include <optional>
#include <span>

#include "common/assert.h"
#include "server/physics/mechanics/organs/node_transfer.h"

namespace prosector {

/// A tetrahedron of a piece before the cut.
struct OldTet {
  std::uint32_t piece = 0;
  std::size_t tet = 0;  // index in the piece
};

/// Returns the old tetrahedron that is `tet` or its ancestor; none where a cut was undone.
std::optional<OldTet> find_old(const TetComplex& complex, std::span<const PieceMesh* const> before,
                               TetId tet);

/// Returns the number of history values per tetrahedron. Every tetrahedron must be an element.
inline Eigen::Index history_per_tet(const VecX& history, const PieceMesh& mesh) {
  PROSECTOR_ASSERT(!mesh.tets.empty());
  return history.size() / static_cast<Eigen::Index>(mesh.tets.size());
}

/// Returns the viscoelastic history (relaxation.h) of these tetrahedra, `numbers` values each. A tetrahedron
/// inherits the values of its ancestor; zero without an ancestor. `histories`: by piece in `before`.
VecX carried_history(const TetComplex& complex, std::span<const PieceMesh* const> before,
                     std::span<const VecX* const> histories, Eigen::Index numbers,
                     std::span<const TetId> tets);

}  // namespace prosector
