#pragma once
// Which tetrahedron of a body, as it was before a cut, one that the cut made is a part of; and what it has of
// it.

#include <optional>
#include <span>

#include "server/physics/organs/node_transfer.h"

namespace prosector {

struct OldTet {
  std::uint32_t piece = 0;
  std::size_t tet = 0;  // its index there
};

/// Returns the tetrahedron that was where `tet` is now, or the one that `tet` comes from; none where a cut
/// was taken back.
std::optional<OldTet> find_old(const TetComplex& complex, std::span<const PieceMesh* const> before,
                               TetId tet);

/// Returns how many numbers of the history each tetrahedron has, where every one of them is an element.
inline Eigen::Index history_per_tet(const VecX& history, const PieceMesh& mesh) {
  return history.size() / static_cast<Eigen::Index>(mesh.tets.size());
}

/// Returns the viscoelastic history (relaxation.h) of these tetrahedra, `numbers` of each. What a tetrahedron
/// comes from had it, at the same strain; nothing where there was none. `histories`: those of each piece in
/// `before`.
VecX carried_history(const TetComplex& complex, std::span<const PieceMesh* const> before,
                     std::span<const VecX* const> histories, Eigen::Index numbers,
                     std::span<const TetId> tets);

}  // namespace prosector
