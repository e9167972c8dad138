#include "client/view/real_objects.h"

#include <algorithm>

#include "client/view/body_mesh.h"

namespace prosector {
namespace {

constexpr double below_board = 0.005;  // m: depth of a point in the table

/// Makes the item of a phantom occlude instead of being drawn. Returns whether the body is a phantom.
bool show_phantom(DrawItem& item, const SceneBody& body, const CameraOverlay& through) {
  const bool found = through.found && body.name == through.found->body;
  if (!found && std::ranges::find(through.phantoms, body.name) == through.phantoms.end()) return false;
  item.showing = ItemRole::real;
  if (found) item.pose = through.found->place.value_or(item.pose);
  return true;
}

}  // namespace

void RealObjects::add(DrawList& list, const DrawnBodies& bodies, const Replica& replica,
                      const CameraOverlay& through, std::uint64_t& next_mesh_id) {
  const Pose& board = through.room_board;
  const Vec3 up = board.q * Vec3::UnitZ();
  const Vec3 shown = rendered_paper_color(list, board.p, up);
  for (const auto& [body, index, inner] : bodies.items()) {
    const SceneBody& one = replica.scene()->bodies[body];
    DrawItem& item = list.items[index];
    if (show_phantom(item, one, through)) continue;
    if (through.paper) match_lighting(item, shown, *through.paper);
    if (one.kind != BodyKind::rigid || one.moves || one.part ||
        !bodies.box_of(list, body).contains(board.p - below_board * up))
      continue;
    item.showing = ItemRole::around;
    item.casts_shadow = false;
  }
  add_table(list, board, next_mesh_id);
  if (through.found) add_phantom(list, *through.found, next_mesh_id);
}

void RealObjects::add_table(DrawList& list, const Pose& board, std::uint64_t& next_mesh_id) {
  DrawItem plane = table_plane(board, next_mesh_id);
  if (!table_) {
    table_ = plane.mesh;
    ++next_mesh_id;
  }
  plane.mesh = table_;
  list.items.push_back(plane);
}

/// Adds a phantom whose shape is not that of a body.
void RealObjects::add_phantom(DrawList& list, const FoundPhantom& found, std::uint64_t& next_mesh_id) {
  if (!found.shape || !found.place) return;
  if (!phantom_) phantom_ = rigid_mesh(*found.shape, next_mesh_id++);
  list.items.push_back({.mesh = phantom_, .pose = *found.place, .appearance = {}, .showing = ItemRole::real});
}

}  // namespace prosector
