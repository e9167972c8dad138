#pragma once
// Fingernails: plates on the backs of the fingertips, which distinguish a hand's back from its palm.

#include <memory>

#include "client/view/draw_list.h"
#include "common/hand.h"

namespace prosector {

/// Makes the nails of an open right or left hand, in its wrist's frame, m.
std::shared_ptr<DrawMesh> make_nails(std::size_t hand, std::uint64_t mesh_id);

/// Moves the nails of make_nails() with the fingers and increments the mesh's positions_revision.
void bend_nails(std::size_t hand, const std::array<double, fingers>& flexion, DrawMesh& nails);

/// Returns the nails' appearance for a hand's appearance: a little paler and smoother.
Appearance nail_look(const Appearance& hand);

}  // namespace prosector
