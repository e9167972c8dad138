#include "client/view/parts_board_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace prosector {
namespace {

constexpr double plate_step = 2e-5;           // m, distance of each plate from the one below it
constexpr double board_thickness = 3e-3;      // m
constexpr double writing_before = 4e-4;       // m, distance of letters from the plates
constexpr double min_visible_opacity = 0.02;  // minimum drawn opacity
constexpr int arc_steps = 5;                  // segments per round corner

Vec3 place(const Eigen::Vector2d& point, double z) {
  const Eigen::Vector2d off = board_metres_per_point * (point - parts_board_picture / 2);
  return {off.x(), -off.y(), z};
}

using Outline = std::vector<Eigen::Vector2d>;  // points, counterclockwise as the reader sees it

/// Returns a rectangle with round corners. All outlines have the same number of points, so that two form a
/// ring.
Outline rounded(const Eigen::Vector2d& low, const Eigen::Vector2d& high, double radius) {
  constexpr double least_radius = 0.01;  // points
  const double r = std::min(std::max(radius, least_radius), (high - low).minCoeff() / 2);
  const std::array<Eigen::Vector2d, 4> middles = {{{high.x() - r, low.y() + r},
                                                   {low.x() + r, low.y() + r},
                                                   {low.x() + r, high.y() - r},
                                                   high.array() - r}};
  Outline out;
  for (std::size_t corner = 0; corner < middles.size(); ++corner)
    for (int step = 0; step <= arc_steps; ++step) {
      const double angle =
          std::numbers::pi / 2 * (static_cast<double>(corner) + static_cast<double>(step) / arc_steps);
      out.push_back(middles[corner] + r * Eigen::Vector2d(std::cos(angle), -std::sin(angle)));
    }
  return out;
}

/// The plates of an overlay as one mesh in the board's frame. The first plate is the board, which has a back.
class PlatesMesh {
 public:
  explicit PlatesMesh(const DrawPlate& board) : ground_(board.color) {
    const Outline outline = rounded(board.low, board.high, board.radius);
    fill(outline, 0, Vec3::UnitZ(), board.color);
    fill({outline.rbegin(), outline.rend()}, -board_thickness, -Vec3::UnitZ(), board.color);
    const std::uint32_t front = add_points(outline, 0, Vec3::UnitZ(), board.rim_color);
    join(add_points(outline, -board_thickness, Vec3::UnitZ(), board.rim_color), front);
    add_rim(board);
  }

  void add(const DrawPlate& plate) {
    front_ += plate_step;
    if (plate.opacity > min_visible_opacity)
      fill(rounded(plate.low, plate.high, plate.radius), front_, Vec3::UnitZ(),
           ground_ + plate.opacity * (plate.color - ground_));
    add_rim(plate);
  }

  double front() const { return front_; }

  /// Updates the mesh's shape and colours, if they changed.
  void put_into(DrawMesh& mesh) && {
    if (mesh.positions == positions_ && mesh.rest_positions == colors_) return;
    mesh.positions = std::move(positions_);
    mesh.normals = std::move(normals_);
    mesh.rest_positions = std::move(colors_);
    mesh.triangles = std::move(triangles_);
    ++mesh.revision;
  }

 private:
  Vec3 ground_;
  double front_ = 0;  // m, front of the newest plate
  std::vector<Eigen::Vector3f> positions_, normals_, colors_;
  Triangles triangles_;

  std::uint32_t add_points(const Outline& outline, double z, const Vec3& normal, const Vec3& color) {
    const auto first = static_cast<std::uint32_t>(positions_.size());
    for (const Eigen::Vector2d& point : outline) positions_.push_back(place(point, z).cast<float>());
    normals_.resize(positions_.size(), normal.cast<float>());
    colors_.resize(positions_.size(), color.cast<float>());
    return first;
  }

  void fill(const Outline& outline, double z, const Vec3& normal, const Vec3& color) {
    const std::uint32_t first = add_points(outline, z, normal, color);
    for (std::uint32_t k = 2; k < outline.size(); ++k)
      triangles_.push_back({first, first + k - 1, first + k});
  }

  /// Connects two outlines; the second is the inner or the nearer one.
  void join(std::uint32_t outer, std::uint32_t inner) {
    const auto count = static_cast<std::uint32_t>(4 * (arc_steps + 1));
    for (std::uint32_t k = 0; k < count; ++k) {
      const std::uint32_t next = (k + 1) % count;
      triangles_.push_back({outer + k, outer + next, inner + next});
      triangles_.push_back({outer + k, inner + next, inner + k});
    }
  }

  void add_rim(const DrawPlate& plate) {
    if (plate.rim_width <= 0) return;
    const Eigen::Vector2d width = Eigen::Vector2d::Constant(plate.rim_width);
    const Outline outline = rounded(plate.low, plate.high, plate.radius);
    const Outline inner = rounded(plate.low + width, plate.high - width, plate.radius - plate.rim_width);
    front_ += plate_step;
    const std::uint32_t outer = add_points(outline, front_, Vec3::UnitZ(), plate.rim_color);
    join(outer, add_points(inner, front_, Vec3::UnitZ(), plate.rim_color));
  }
};

/// Returns the text positioned on the board, in front of its plates.
DrawText on_board(DrawText text, const Pose& board, double front) {
  text.overlay = false;
  text.surface = board * Pose{place({text.at.x(), text.at.y()}, front + writing_before), Quat::Identity()};
  for (double* length : {&text.height, &text.wrap, &text.least_height, &text.tallest})
    *length *= board_metres_per_point;
  return text;
}

}  // namespace

Eigen::Vector2d board_point(const Vec3& place) {
  return parts_board_picture / 2 + Eigen::Vector2d(place.x(), -place.y()) / board_metres_per_point;
}

void PartsBoardView::add(DrawList& out, const PlacedPartsList& placed) {
  DrawList flat;
  flat.words = out.words;
  add_parts_list(flat, *placed.list);
  PlatesMesh plates(flat.plates.front());
  for (std::size_t k = 1; k < flat.plates.size(); ++k) plates.add(flat.plates[k]);
  for (const DrawText& text : flat.texts) out.texts.push_back(on_board(text, placed.pose, plates.front()));
  std::move(plates).put_into(*mesh_);
  out.items.push_back(
      {.mesh = mesh_, .pose = placed.pose, .appearance = {}, .casts_shadow = false, .painted = true});
}

}  // namespace prosector
