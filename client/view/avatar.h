#pragma once
// Other users as people with their names.

#include <array>
#include <memory>
#include <string>

#include "client/view/draw_list.h"
#include "client/view/figure.h"

namespace prosector {

/// A person's meshes, shared by all people.
struct FigureMeshes {
  std::shared_ptr<const DrawMesh> head, cap, mask, bust, eyes, forearm;

  static constexpr std::uint64_t meshes = 6;
  /// Takes mesh ids from `first_mesh_id` on.
  FigureMeshes(const FigureSurfaces& surfaces, std::uint64_t first_mesh_id);
};

/// Adds head and shoulders in the user's colour and the name above them.
void add_avatar(DrawList& list, const FigureMeshes& figure, const Pose& head, const Vec3& color,
                const std::string& name);

/// Adds a forearm with its cuff, as forearm_behind() puts it.
void add_forearm(DrawList& list, const FigureMeshes& figure, const Pose& forearm, const Vec3& color);

}  // namespace prosector
