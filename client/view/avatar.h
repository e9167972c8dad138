#pragma once
// Avatars of other users, with their names.

#include <array>
#include <memory>
#include <string>

#include "client/view/avatar_shapes.h"
#include "client/view/draw_list.h"

namespace prosector {

/// Render meshes of an avatar without its hands, shared by the avatars of all users.
struct FigureMeshes {
  std::shared_ptr<const DrawMesh> head, cap, mask, bust, eyes, forearm;

  static constexpr std::uint64_t meshes = 6;
  /// Creates render meshes of the avatar's surfaces. They get the ids `first_mesh_id` … `first_mesh_id` +
  /// meshes − 1.
  FigureMeshes(const FigureSurfaces& surfaces, std::uint64_t first_mesh_id);
};

/// Adds an avatar's head and shoulders in the user's colour (linear RGB), with the user's name above them.
/// `head`: pose of the eyes, room frame.
void add_avatar(DrawList& list, const FigureMeshes& figure, const Pose& head, const Vec3& color,
                const std::string& name);

/// Adds an avatar's forearm with its cuff in the user's colour (linear RGB). `forearm`: room pose computed by
/// forearm_behind().
void add_forearm(DrawList& list, const FigureMeshes& figure, const Pose& forearm, const Vec3& color);

}  // namespace prosector
