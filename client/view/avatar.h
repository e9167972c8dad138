#pragma once
// Other users as pyramid heads with their axes and names; the frame of the room in a corner of one's own
// view.

#include <memory>
#include <string>

#include "client/view/draw_list.h"

namespace prosector {

/// Makes a pyramid of a head's size: its apex points ahead (−z), its base is the back of the head.
std::shared_ptr<const DrawMesh> head_mesh(std::uint64_t mesh_id);

/// Adds the head in the user's colour, its local axes (x red, y green, z blue) and its name above it.
void add_avatar(DrawList& list, const std::shared_ptr<const DrawMesh>& head, const Pose& pose,
                const Vec3& color, const std::string& name);

/// Adds axes of `length` metres at `frame`.
void add_axes(DrawList& list, const Pose& frame, double length);

/// Adds the axes of `frame` as `camera` sees their directions, in the lower left corner of every view.
void add_corner_axes(DrawList& list, const Quat& frame, const DrawCamera& camera);

}  // namespace prosector
