#pragma once
// Avatars of other users, with their names.

#include <array>
#include <memory>
#include <string>

#include "client/view/avatar_shapes.h"
#include "client/view/draw_list.h"

namespace prosector {

/// Meshes of an avatar, shared by all avatars.
struct FigureMeshes {
  std::shared_ptr<const DrawMesh> head, cap, mask, bust, eyes, forearm;

  static constexpr std::uint64_t meshes = 6;
  /// Assigns the mesh ids `first_mesh_id` … `first_mesh_id` + meshes − 1.
  FigureMeshes(const FigureSurfaces& surfaces, std::uint64_t first_mesh_id);
};

/// Adds head and shoulders in the user's colour, with the name above them.
void add_avatar(DrawList& list, const FigureMeshes& figure, const Pose& head, const Vec3& color,
                const std::string& name);

/// Adds a forearm with its cuff at a pose computed by forearm_behind().
void add_forearm(DrawList& list, const FigureMeshes& figure, const Pose& forearm, const Vec3& color);

}  // namespace prosector
