#pragma once
// Render mesh of a hand's skin.

#include <memory>

#include "client/view/draw_list.h"
#include "common/hands/hand_skin.h"

namespace prosector {

/// Makes a mesh of the open hand. Its `rest_positions` hold the open shape, so that textures stick.
std::shared_ptr<DrawMesh> make_hand_mesh(const HandSkin& skin, std::uint64_t mesh_id);

/// Bends a mesh of make_hand_mesh() and increments its positions_revision.
void bend_hand(const HandSkin& skin, DrawMesh& mesh, const std::array<double, fingers>& flexion);

}  // namespace prosector
