#pragma once
// Fingernails: plates on the backs of the fingertips, which distinguish a hand's back from its palm.

#include <memory>

#include "client/view/draw_list.h"
#include "common/hand.h"

namespace prosector {

/// Creates the render mesh of the fingernails of an open hand, in its wrist's frame, m. `hand`: left_hand or
/// right_hand.
std::shared_ptr<DrawMesh> make_nails(std::size_t hand, std::uint64_t mesh_id);

/// Moves the fingernails that make_nails() created with the bent fingers (flexion 0 open … 1 closed, thumb
/// first), and increments the mesh's positions_revision.
void bend_nails(std::size_t hand, const std::array<double, fingers>& flexion, DrawMesh& nails);

/// Returns the appearance of the fingernails of a hand with this appearance: a little paler and smoother.
Appearance nail_look(const Appearance& hand);

}  // namespace prosector
