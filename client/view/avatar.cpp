#include "client/view/avatar.h"

#include <array>

#include "client/view/body_mesh.h"
#include "common/scene/primitives.h"

namespace prosector {
namespace {

constexpr double name_above = 0.2;  // m, above the eyes

const Appearance eyes_look{.color = {0.03, 0.03, 0.035}, .roughness = 0.2};

const Appearance mask_look{.color = {0.6, 0.68, 0.7}, .roughness = 0.9, .surface = Surface::cloth};

/// Returns the face's appearance: tinted in the user's colour, but pale enough that shading is visible.
Appearance face_look(const Vec3& color) {
  return {.color = 0.55 * Vec3(0.85, 0.83, 0.8) + 0.3 * color, .roughness = 0.6, .surface = Surface::skin};
}

Appearance coat_look(const Vec3& color) {
  return {.color = 0.85 * color + Vec3::Constant(0.03), .roughness = 0.85, .surface = Surface::cloth};
}

TriangleMesh eyes_surface() {
  std::array<PartDesc, 2> eyes;
  for (std::size_t k = 0; k < 2; ++k) {
    eyes[k].shape = "sphere";
    eyes[k].size = Vec3::Constant(0.022);
    eyes[k].pose.p = {k == 0 ? -0.03 : 0.03, 0, 0.001};
  }
  return mesh_of(eyes);
}

}  // namespace

FigureMeshes::FigureMeshes(const FigureSurfaces& surfaces, std::uint64_t first_mesh_id)
    : head(rigid_mesh(surfaces.head, first_mesh_id)),
      cap(rigid_mesh(surfaces.cap, first_mesh_id + 1)),
      mask(rigid_mesh(surfaces.mask, first_mesh_id + 2)),
      bust(rigid_mesh(surfaces.bust, first_mesh_id + 3)),
      eyes(rigid_mesh(eyes_surface(), first_mesh_id + 4)),
      forearm(rigid_mesh(surfaces.forearm, first_mesh_id + 5)) {}

void add_avatar(DrawList& list, const FigureMeshes& figure, const Pose& head, const Vec3& color,
                const std::string& name) {
  list.items.push_back({.mesh = figure.head, .pose = head, .appearance = face_look(color)});
  list.items.push_back({.mesh = figure.eyes, .pose = head, .appearance = eyes_look});
  list.items.push_back({.mesh = figure.cap, .pose = head, .appearance = coat_look(color)});
  list.items.push_back({.mesh = figure.mask, .pose = head, .appearance = mask_look});
  list.items.push_back({.mesh = figure.bust, .pose = bust_below(head), .appearance = coat_look(color)});
  DrawText label;
  label.text = name;
  label.at = head.p + Vec3(0, name_above, 0);
  label.overlay = false;
  list.texts.push_back(label);
}

void add_forearm(DrawList& list, const FigureMeshes& figure, const Pose& forearm, const Vec3& color) {
  list.items.push_back({.mesh = figure.forearm, .pose = forearm, .appearance = coat_look(color)});
}

}  // namespace prosector
