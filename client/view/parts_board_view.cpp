#include "client/view/parts_board_view.h"

#include "client/view/body_mesh.h"
#include "common/primitives.h"

namespace prosector {
namespace {

constexpr double plate_step = 2e-5;       // m, that each plate stands before the one below it
constexpr double plate_thickness = 1e-3;  // m
constexpr double writing_before = 4e-4;   // m, of letters before all plates
constexpr double least_seen = 0.02;       // opacity

/// Plates and texts of an overlay, as things on a board.
class BoardPlates {
 public:
  BoardPlates(DrawList& out, const Pose& board, const std::shared_ptr<const DrawMesh>& cube)
      : out_(out), board_(board), cube_(cube) {}

  void add(const DrawPlate& plate) {
    front_ += plate_step;
    if (plate.opacity > least_seen) slab(plate.low, plate.high, plate.color, plate.opacity);
    if (plate.rim_width <= 0) return;
    const double w = plate.rim_width;
    const Eigen::Vector2d &low = plate.low, &high = plate.high;
    slab(low, {high.x(), low.y() + w}, plate.rim_color, 1);
    slab({low.x(), high.y() - w}, high, plate.rim_color, 1);
    slab({low.x(), low.y() + w}, {low.x() + w, high.y() - w}, plate.rim_color, 1);
    slab({high.x() - w, low.y() + w}, {high.x(), high.y() - w}, plate.rim_color, 1);
  }

  void add(const DrawText& text) {
    DrawText on_board = text;
    const Vec3 at = place({text.at.x(), text.at.y()}, front_ + writing_before);
    on_board.overlay = false;
    on_board.surface = board_ * Pose{at, Quat::Identity()};
    for (double* length : {&on_board.height, &on_board.wrap, &on_board.least_height, &on_board.tallest})
      *length *= board_metres_per_point;
    out_.texts.push_back(std::move(on_board));
  }

 private:
  DrawList& out_;
  const Pose& board_;
  const std::shared_ptr<const DrawMesh>& cube_;
  double front_ = 0;  // m, of the newest plate

  static Vec3 place(const Eigen::Vector2d& point, double z) {
    const Eigen::Vector2d off = board_metres_per_point * (point - parts_board_picture / 2);
    return {off.x(), -off.y(), z};
  }

  void slab(const Eigen::Vector2d& low, const Eigen::Vector2d& high, const Vec3& color, double opacity) {
    const Vec3 middle = place((low + high) / 2, front_ - plate_thickness / 2);
    const Eigen::Vector2d size = board_metres_per_point * (high - low);
    Affine shape;
    shape.A = board_.q.toRotationMatrix() * Vec3(size.x(), size.y(), plate_thickness).asDiagonal();
    shape.p = board_ * middle;
    out_.items.push_back({.mesh = cube_,
                          .pose = {},
                          .appearance = {.color = color, .surface = Surface::emissive},
                          .casts_shadow = false,
                          .shape = shape,
                          .opacity = opacity});
  }
};

}  // namespace

Eigen::Vector2d board_point(const Vec3& place) {
  return parts_board_picture / 2 + Eigen::Vector2d(place.x(), -place.y()) / board_metres_per_point;
}

void add_parts_board(DrawList& out, const PlacedPartsList& placed,
                     const std::shared_ptr<const DrawMesh>& cube) {
  DrawList flat;
  add_parts_list(flat, *placed.list);
  // The hint for names and the search, which stands last, tells of a mouse and of keys.
  using Kind = PartsSpot::Kind;
  const auto& hovered = placed.list->state.hovered;
  if (hovered && (hovered->kind == Kind::name || hovered->kind == Kind::search)) flat.texts.pop_back();
  BoardPlates board(out, placed.pose, cube);
  for (DrawPlate& plate : flat.plates) {
    if (&plate == &flat.plates.front()) plate.opacity = 1;  // nothing shines through a board in the room
    board.add(plate);
  }
  for (const DrawText& text : flat.texts) board.add(text);
}

std::shared_ptr<const DrawMesh> board_cube(std::uint64_t mesh_id) {
  PartDesc cube;
  cube.size = Vec3::Ones();
  return rigid_mesh(mesh_of(cube), mesh_id);
}

}  // namespace prosector
