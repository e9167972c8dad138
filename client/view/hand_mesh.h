#pragma once
// A hand's skin as something to draw.

#include <memory>

#include "client/view/draw_list.h"
#include "common/hand_skin.h"

namespace prosector {

/// Makes a new mesh of the open hand; `rest_positions` hold the open shape, so that texture sticks.
std::shared_ptr<DrawMesh> make_hand_mesh(const HandSkin& skin, std::uint64_t mesh_id);

/// Bends `mesh` (made by make_hand_mesh) and raises its positions_revision.
void bend_hand(const HandSkin& skin, DrawMesh& mesh, const std::array<double, fingers>& flexion);

}  // namespace prosector
