#pragma once
// Render mesh of a hand's skin.

#include <memory>

#include "client/view/draw_list.h"
#include "common/hands/hand_skin.h"

namespace prosector {

/// Creates the render mesh of the open hand's skin. Its `rest_positions` hold the open shape, so that
/// textures stick to the skin when the fingers bend.
std::shared_ptr<DrawMesh> make_hand_mesh(const HandSkin& skin, std::uint64_t mesh_id);

/// Deforms a mesh that make_hand_mesh() created so that its fingers have these flexions (0 open … 1 closed,
/// thumb first), and increments its positions_revision.
void bend_hand(const HandSkin& skin, DrawMesh& mesh, const std::array<double, fingers>& flexion);

}  // namespace prosector
